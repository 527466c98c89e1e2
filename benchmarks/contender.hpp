#pragma once
// One way to compute a scene.

#include <functional>
#include <span>
#include <string>

namespace bench {

struct Contender {
  std::string name;
  /// Moves a state by `steps` steps of classical RK4 from time 0 and returns how often the right-hand side was
  /// evaluated.
  std::function<long(std::span<double> state, double step, long steps)> integrate;
};

}  // namespace bench
