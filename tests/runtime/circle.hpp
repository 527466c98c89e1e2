#pragma once
// A circle to follow, runs to the end, and who watches the steps.

#include <array>

#include "equation.hpp"
#include "mbrt/dynamics.hpp"

namespace mbrt::test {

inline auto circle() {
  return equation<std::array<double, 2>>([](double, const auto& y, auto& rate) { rate = {-y[1], y[0]}; });
}

inline Task task(double from, double to, double tolerance) { return {from, to, 0, tolerance, {}, false}; }

/// To the task's end, which becomes y.
template <class Method, class M>
Course run_to(M& model, typename M::State& y, const Task& task) {
  Unobserved nobody;
  return Method::run(model, y, task, nobody);
}

/// Asks `see(time, between)` at the end of every step whether to go on.
template <class Function>
struct Watching {
  Function see;
  void arriving() {}
  template <class State>
  bool accepted(double, const State&, const State&) {
    return true;
  }
  template <class State, class Between>
  bool accepted(double time, const State&, const State&, const Between& between) {
    return see(time, between);
  }
};
template <class Function>
Watching(Function) -> Watching<Function>;

}  // namespace mbrt::test
