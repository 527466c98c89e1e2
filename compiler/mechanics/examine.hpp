#pragma once
// Physics checked when compiling: the equations at the start of a run, with the parameters' default values.

#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "mechanics/derivatives.hpp"

namespace mbcc {

namespace mechanics {

/// What was found at the start.
struct Examination {
  std::vector<std::size_t> ranks;      ///< per island
  std::vector<std::size_t> redundant;  ///< constraints that depend on earlier ones
};

/// A start counts as consistent while its distance from each constraint, |h| / |A_k| in the coordinates and
/// |h'| / |A_k| in the speeds, is at most this times the size of the state, at least 1: what is typed with seven
/// digits passes, a wrong digit does not.
inline constexpr double start_tolerance = 1e-6;

/// Whether the model's own start has to be consistent, or will be moved to where it is.
enum class Start { Consistent, Assembled };

}  // namespace mechanics

/// Reports what is wrong with the physics of the model at the lines that caused it.
mechanics::Examination examine(const model::System& system, const mechanics::Equations& equations,
                               const mechanics::Derivatives& derivatives, mechanics::Start start,
                               Diagnostics& diagnostics);

}  // namespace mbcc
