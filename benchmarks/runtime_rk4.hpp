#pragma once
// A system integrated by the runtime's own RK4.

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "contender.hpp"
#include "mbrt/rk4.hpp"

namespace bench {

template <mbrt::Dynamics System>
Contender with_runtime_rk4(std::string name, std::shared_ptr<System> system) {
  return {std::move(name), [system](std::span<double> state, double step, long steps) {
            typename System::State y;
            std::copy(state.begin(), state.end(), y.begin());
            mbrt::Unobserved nobody;
            mbrt::rk4(*system, y, mbrt::TimeGrid{0, static_cast<double>(steps) * step, step, steps}, nobody);
            std::copy(y.begin(), y.end(), state.begin());
            return 4 * steps + 1;
          }};
}

}  // namespace bench
