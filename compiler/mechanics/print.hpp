#pragma once
// Equations and derivatives as text, for dumps.

#include <string>

#include "graph/print.hpp"
#include "mechanics/derivatives.hpp"

namespace mbcc {

namespace mechanics {

graph::LeafName leaf_names(const model::System& system);

/// The FEED form of every constraint at the start: value, all first and all second partial derivatives, with the
/// paper's flags: whether t and whether velocities occur. Nonholonomic constraints are carried to first order.
std::string print_partials(const model::System& system, const Equations& equations);

}  // namespace mechanics

std::string print(const mechanics::Equations& equations, const model::System& system);  ///< `dump --stage=equations`
std::string print(const mechanics::Derivatives& derivatives, const model::System& system);  ///< `--stage=derivatives`

}  // namespace mbcc
