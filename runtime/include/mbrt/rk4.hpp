#pragma once
// The classical Runge-Kutta method of order four with constant step.

#include <cmath>
#include <concepts>
#include <cstddef>

namespace mbrt {

/// A first-order system y' = f(t, y). `State` is an indexable range of doubles; the time is set before `rates`.
template <class M>
concept Dynamics = requires(M& model, const typename M::State& state, typename M::State& rate, double time) {
  model.set_time(time);
  model.rates(state, rate);
};

/// The times of a run: `from` + i `step`; the last step is shortened to end at `to` where the step does not divide the
/// span.
struct TimeGrid {
  double from;
  double to;
  double step;
  long steps;

  double time(long i) const { return i > 0 && i == steps ? to : from + static_cast<double>(i) * step; }
};

/// A span that exceeds a whole number of steps by less than 1e-9 of a step is a rounding error, not one step more.
inline TimeGrid time_grid(double from, double to, double step) {
  return {from, to, step, static_cast<long>(std::ceil((to - from) / step - 1e-9))};
}

/// Sees each state that a method accepts, the start included. `arriving` is called before the rate there is evaluated,
/// `accepted` after it, with the model's time set to `time`; it may set another, and false ends the run.
template <class O, class State>
concept StepObserver = requires(O& observer, double time, const State& state) {
  observer.arriving();
  { observer.accepted(time, state, state) } -> std::convertible_to<bool>;
};

/// The observer of a run of which only the end is wanted.
struct Unobserved {
  void arriving() {}
  template <class State>
  bool accepted(double, const State&, const State&) {
    return true;
  }
};

/// Moves `y` from grid.from to grid.to. The rate at an accepted state is the first stage of the step that follows, so
/// that observing costs no evaluation: 4 steps + 1 in all. Allocates nothing, unless copying a State does, at the
/// start alone.
///
/// The loops are unrolled so that a small state passes from `rates`, where it is inlined, in registers: read back as
/// vectors, what was just stored as numbers costs a quarter of the time of such a step.
template <Dynamics M, StepObserver<typename M::State> Observer>
void rk4(M& model, typename M::State& y, const TimeGrid& grid, Observer& observer) {
  typename M::State k1 = y, k2 = y, k3 = y, k4 = y, stage = y;
  const std::size_t size = y.size();
  double t = grid.from;
  model.set_time(t);
  for (long i = 0;; ++i) {
    observer.arriving();
    model.rates(y, k1);
    if (!observer.accepted(t, y, k1) || i == grid.steps) {
      return;
    }
    const double next = grid.time(i + 1);
    const double h = i + 1 == grid.steps ? next - t : grid.step;
    model.set_time(t + 0.5 * h);
#pragma GCC unroll 32
    for (std::size_t j = 0; j < size; ++j) {
      stage[j] = y[j] + 0.5 * h * k1[j];
    }
    model.rates(stage, k2);
#pragma GCC unroll 32
    for (std::size_t j = 0; j < size; ++j) {
      stage[j] = y[j] + 0.5 * h * k2[j];
    }
    model.rates(stage, k3);
    t = next;
    model.set_time(t);
#pragma GCC unroll 32
    for (std::size_t j = 0; j < size; ++j) {
      stage[j] = y[j] + h * k3[j];
    }
    model.rates(stage, k4);
#pragma GCC unroll 32
    for (std::size_t j = 0; j < size; ++j) {
      y[j] += h / 6 * (k1[j] + 2 * (k2[j] + k3[j]) + k4[j]);
    }
  }
}

}  // namespace mbrt
