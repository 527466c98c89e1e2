#pragma once
// Why a run cannot go on, in the words of the model.

#include <span>
#include <string>
#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// Names the force or the constraint that is not a finite number at `state`; the model's time is `time`.
std::string explain_not_finite(AnyModel& model, const std::vector<Island>& islands, double time,
                               std::span<const double> state);

/// Names the constraints of island `k` that no acceleration satisfies together at `state`; empty if there are none.
/// `residuals` are those of all constraints, as the message shows them.
///
/// Meant for islands whose rank is deficient there: rows of full rank cannot contradict each other.
///
/// Leaves its traces in the island's record.
///
/// Note [contradiction]: the residual |A_k u' - b_k| of a row is compared with the size of the row's own terms,
///   |b_k| + sum_j |A_kj| (|a_j| + |c_j|) + |A_k| |u|^2 / |q|,  c = u' - a,
/// the last one standing for terms that cancel inside b_k. Rows that agree on the constraint manifold disagree off it:
/// at a relative distance d each term, a polynomial of degree p or like one, is off by about p d of itself, so that
/// residuals up to 10 d are drift. The distance is that of the smallest displacements that A turns into the errors of
/// position and velocity: to first order, drift can make no other errors, whereas those of contradictory constraints
/// are just the ones that no displacement explains. Residuals up to 1e-6 are what a cut-off of 1e-8 leaves in rows that
/// it holds for parallel, with a margin.
std::string find_contradiction(AnyModel& model, const Island& island, int k, double time, std::span<const double> state,
                               std::span<const double> rate, std::span<const double> residuals);

}  // namespace mbrt
