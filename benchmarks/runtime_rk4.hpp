#pragma once
// A system integrated by the runtime's own RK4.

#include <algorithm>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "contender.hpp"
#include "mbrt/rk4.hpp"

namespace bench {

/// Where a system keeps each component of the scene's state; empty: where the scene has it.
using Places = std::vector<std::size_t>;

template <mbrt::Dynamics System>
Contender with_runtime_rk4(std::string name, std::shared_ptr<System> system, const Places& places = {}) {
  return {
      std::move(name), [system, places](std::span<double> state, double step, long steps) {
        const auto place = [&](std::size_t j) { return places.empty() ? j : places[j]; };
        std::vector<double> kept(state.size());  // the system's own state is not indexed by what is read at run time
        for (std::size_t j = 0; j < state.size(); ++j) {
          kept[place(j)] = state[j];
        }
        typename System::State y;
        std::copy(kept.begin(), kept.end(), y.begin());
        mbrt::Unobserved nobody;
        mbrt::rk4(*system, y, mbrt::TimeGrid{0, static_cast<double>(steps) * step, step, steps}, nobody);
        std::copy(y.begin(), y.end(), kept.begin());
        for (std::size_t j = 0; j < state.size(); ++j) {
          state[j] = kept[place(j)];
        }
        return 4 * steps + 1;
      }};
}

}  // namespace bench
