#pragma once
// A consistent start near a model's own.

#include <vector>

#include "mbrt/rk4.hpp"
#include "mbrt/simulation.hpp"

namespace mbrt {

/// The state nearest to the model's start that satisfies all constraints at `time`: coordinates, then speeds. Empty if
/// the search ends off the constraints.
std::vector<double> nearest_start(AnyModel& model, double time);

template <Model M>
std::vector<double> nearest_start(M& model, double time) {
  BoundModel<M, Rk4> bound(model);  // nothing is integrated
  return nearest_start(static_cast<AnyModel&>(bound), time);
}

}  // namespace mbrt
