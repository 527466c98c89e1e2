#pragma once
// Sums in a shape that costs little.

#include "graph/graph.hpp"

namespace mbcc::mechanics {

/// The same sum with like terms merged and terms of one coefficient gathered: 2 x - 3 (y - x) + 5 z = 5 (x + z) - 3 y.
/// Differentiation along the motion yields each mixed term twice, and what the forces contribute to a constraint is
/// often a multiple of the constraint itself; this finds both.
graph::Expr collect(graph::Expr sum);

}  // namespace mbcc::mechanics
