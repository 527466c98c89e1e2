#pragma once
// What a model has to compute for the Taylor coefficients of its motion, as expressions.
//
// Note [series]: the motion from a state as a power series, order by order, with one factorisation for all of them.
// With coordinates known to order k + 1 and speeds to order k, the pass of order k
//   1. updates the operands of all lanes (Note [lanes], expansion.hpp) and the free accelerations a_k;
//   2. computes the sums of all lanes;
//   3. solves for u'_k, which gives u_(k+1) = u'_k / (k + 1) and from that q_(k+2).
// Differentiating b and S is not needed for the solve: along the motion a holonomic constraint h has h'' = 0 beyond the
// errors of its start, that is h_(k+2) = 0 (a nonholonomic g: g_(k+1) = 0), and the coefficient is linear in what is
// sought,
//   (k+1)(k+2) h_(k+2) = A_0 u'_k + (k+1)(k+2) H,  H the coefficient with u'_k = 0,
//   u'_k = a_k + M^-1 (A_0^T z_k + sum over j < k of A_(k-j)^T z_j) = c_k + M^-1 A_0^T z_k,
// so that S_0 z_k = -(k+1)(k+2) H - A_0 c_k, with S_0 = A_0 M^-1 A_0^T the matrix of the ordinary solve. For rods this
// costs less than half the convolutions that S, b and z would: H needs but squares, and A comes with them. Where the
// rows alone determine the accelerations, A_0 u'_k = -(k+1)(k+2) H.
// A switch (abs, sign, min, max, comparisons) has no series across the point where its argument changes sign. The
// coefficients of the arguments are computed as well: steps end there.
// The factorisation must be the plain step of Note [rank ladder] (runtime/include/mbrt/island.hpp): where the rank
// changes the motion need not have a series.

#include <vector>

#include "program/plan.hpp"

namespace mbcc::program {

/// Expressions of level State in `start`, of level Order in the rest; one pass is `fast`, `slow` (not at k = 0, where
/// `start` has done it), sums, `solve`.
struct SeriesPlan {
  std::vector<Wanted> start;  ///< at order 0
  std::vector<Wanted> fast;   ///< operands of order k + 1
  std::vector<Wanted> slow;   ///< operands and free accelerations of order k
  std::vector<Wanted> solve;  ///< multipliers of order k, speeds of order k + 1, coordinates of order k + 2
  std::vector<std::vector<mechanics::Pivot>> pivots;  ///< by island
  std::size_t products = 0;
  std::size_t slow_products = 0;
  std::size_t squares = 0;
  std::size_t slow_squares = 0;
  std::size_t switches = 0;

  std::vector<graph::Expr> roots() const;
};

SeriesPlan plan_series(const model::System& system, const mechanics::Equations& equations,
                       const mechanics::Derivatives& derivatives, graph::Graph& graph);

}  // namespace mbcc::program
