#pragma once
// The classical Runge-Kutta method of order four with constant step.

#include <cmath>
#include <cstddef>

#include "mbrt/dynamics.hpp"

namespace mbrt {

/// The times of a run: `from` + i `step`; the last step is shortened to end at `to` where the step does not divide the
/// span.
struct TimeGrid {
  double from;
  double to;
  double step;
  long steps;

  double time(long i) const { return i > 0 && i == steps ? to : from + static_cast<double>(i) * step; }
};

/// A span that exceeds a whole number of steps by less than 1e-9 of a step is a rounding error, not one step more; but
/// no span is so short that it takes none.
inline TimeGrid time_grid(double from, double to, double step) {
  const long steps = static_cast<long>(std::ceil((to - from) / step - 1e-9));
  return {from, to, step, to > from && steps < 1 ? 1 : steps};
}

/// Moves `y` from grid.from to grid.to. The rate at an accepted state is the first stage of the step that follows, so
/// that observing costs no evaluation: 4 steps + 1 in all. Allocates nothing, unless copying a State does, at the
/// start alone. With `Project` each step's end is moved onto the constraints. Not inlined: what the compiler keeps in
/// registers would depend on the caller (measured: 20 % of the paper's example).
template <bool Project = false, Dynamics M, StepObserver<typename M::State> Observer>
[[gnu::noinline]] Course rk4(M& model, typename M::State& state, const TimeGrid& grid, Observer& observer) {
  typename M::State y = state, k = state, sum = state, stage = state;
  Course course;
  double t = grid.from;
  model.set_time(t);
  for (long i = 0;; ++i) {
    observer.arriving();
    model.rates(y, k);
    const bool goes_on = observer.accepted(t, y, k);
    if (!goes_on || i == grid.steps) {
      course.ending = i == grid.steps ? Ending::Complete : Ending::Stopped;
      course.time = t;
      course.steps = i;
      course.evaluations = 4 * i + 1;
      course.projections = Project ? i : 0;
      break;
    }
    const double next = grid.time(i + 1);
    const double h = i + 1 == grid.steps ? next - t : grid.step;
    const double half = 0.5 * h;
    for_each_component(y, [&](std::size_t j) {
      sum[j] = k[j];
      stage[j] = y[j] + half * k[j];
    });
    model.set_time(t + half);
    model.rates(stage, k);
    for_each_component(y, [&](std::size_t j) {
      sum[j] += 2 * k[j];
      stage[j] = y[j] + half * k[j];
    });
    model.rates(stage, k);
    for_each_component(y, [&](std::size_t j) {
      sum[j] += 2 * k[j];
      stage[j] = y[j] + h * k[j];
    });
    t = next;
    model.set_time(t);
    model.rates(stage, k);
    const double sixth = h / 6;
    for_each_component(y, [&](std::size_t j) { y[j] += sixth * (sum[j] + k[j]); });
    if constexpr (Project) {
      model.project(y);
    }
  }
  state = y;
  return course;
}

/// The method by its name, for `simulate` (simulation.hpp).
struct Rk4 {
  static constexpr const char* name = "rk4";

  /// Moves `state` as `task` says.
  template <Dynamics M, StepObserver<typename M::State> Observer>
  static Course run(M& model, typename M::State& state, const Task& task, Observer& observer) {
    const TimeGrid grid = time_grid(task.from, task.to, task.step);
    if constexpr (Projectable<M>) {
      if (task.project) {
        return rk4<true>(model, state, grid, observer);
      }
    }
    return rk4(model, state, grid, observer);
  }
};

}  // namespace mbrt
