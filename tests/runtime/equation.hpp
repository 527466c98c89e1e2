#pragma once
// y' = f(t, y) of one's choice, as a model of the methods of integration.

#include <vector>

namespace mbrt::test {

template <class StateType, class Function>
struct Equation {
  using State = StateType;
  Function function;
  std::vector<double> times = {};  ///< that were set, in order
  long evaluations = 0;

  void set_time(double time) { times.push_back(time); }
  void rates(const State& y, State& rate) {
    ++evaluations;
    function(times.back(), y, rate);
  }
};

template <class State, class Function>
Equation<State, Function> equation(Function function) {
  return {function};
}

}  // namespace mbrt::test
