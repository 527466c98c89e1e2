#pragma once
// Note [held rows]: a row that is a combination of other rows with constant coefficients, on both sides of A u' = b
// and whatever the state (a constraint written twice, or scaled, or the sum of two others), is held: it leaves the
// solve, which is then the same as with it, and only its error is watched. That is exact, not an approximation: while
// the constraints do not contradict each other, the pseudo-inverse solution of the full system depends on the row space
// of [A b] alone, and that does not change. It must not cost digits either: a row stays in the solve that only a large
// multiple of the difference between other rows makes up, because without it those would be nearly parallel.
//
// Rows that depend on others with coefficients that vary, or at the start alone, stay in the solve, where the rank
// ladder meets them state by state.
//
// Whether a row is such a combination is decided by its values at random states: an identity holds at all of them; what
// is no identity holds at three random points with probability zero. That is true of analytic functions alone: rows
// with `abs`, `max`, `if` and the like may agree near the start and nowhere else, and are never held.

#include <vector>

#include "mechanics/derivatives.hpp"

namespace mbcc::mechanics {

/// The rows of the island that are held, increasing. The later one of two equal rows is.
std::vector<std::size_t> find_implied_rows(const Island& island, const model::System& system,
                                           const Equations& equations, const Derivatives& derivatives);

}  // namespace mbcc::mechanics
