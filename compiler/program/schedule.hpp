#pragma once
// Equations and their derivatives to a Program: elimination, lowering, levels, order.

#include "mechanics/derivatives.hpp"
#include "model/system.hpp"
#include "program/program.hpp"

namespace mbcc {

/// Adds the symbolic elimination to `graph`; the Program owns a graph of its own. It has the derivatives of the rates
/// where a method of the system's integration needs them, and `with_series` what method `taylor` needs.
program::Program schedule(const model::System& system, const mechanics::Equations& equations,
                          const mechanics::Derivatives& derivatives, graph::Graph& graph, bool with_series);

std::string print(const program::Program& program, const model::System& system);  ///< for `dump --stage=program`

}  // namespace mbcc
