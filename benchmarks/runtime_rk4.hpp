#pragma once
// A system integrated by the runtime's own RK4.

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

/// A function of its own, so that the code around it does not decide what the compiler makes of the loop.
template <mbrt::Dynamics System>
[[gnu::noinline]] long run_rk4(System& system, typename System::State& y, double step, long steps) {
  mbrt::Unobserved nobody;
  mbrt::rk4(system, y, mbrt::TimeGrid{0, static_cast<double>(steps) * step, step, steps}, nobody);
  return 4 * steps + 1;
}

template <mbrt::Dynamics System>
Contender with_runtime_rk4(std::string name, std::shared_ptr<System> system, const Places& places = {}) {
  return {std::move(name), [system, places](std::span<double> state, double step, long steps) {
            const auto place = [&](std::size_t j) { return places.empty() ? j : places[j]; };
            typename System::State y;
            for (std::size_t j = 0; j < state.size(); ++j) {
              y[place(j)] = state[j];
            }
            const long evaluations = run_rk4(*system, y, step, steps);
            for (std::size_t j = 0; j < state.size(); ++j) {
              state[j] = y[place(j)];
            }
            return evaluations;
          }};
}

}  // namespace bench
