#pragma once
// The classical Runge-Kutta method of order four with constant step.

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <utility>

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

/// Whether a state is small enough for code without loops, in which the compiler keeps it in registers.
template <class State>
inline constexpr bool is_small = false;
template <std::size_t Size>
inline constexpr bool is_small<std::array<double, Size>> = Size <= 24;

/// Calls f(0), f(1), ... for every component of a state; small states without a loop (measured: 25 % of a chain of 3
/// links, whose rates are stored one by one and would be read back as vectors).
template <class State, class Function>
[[gnu::always_inline]] inline void for_each_component(const State& state, const Function& f) {
  if constexpr (is_small<State>) {
    [&]<std::size_t... J>(std::index_sequence<J...>) { (f(J), ...); }
    (std::make_index_sequence<std::tuple_size_v<State>>{});
  } else {
    const std::size_t size = state.size();
    for (std::size_t j = 0; j < size; ++j) {
      f(j);
    }
  }
}

/// Moves `y` from grid.from to grid.to. The rate at an accepted state is the first stage of the step that follows, so
/// that observing costs no evaluation: 4 steps + 1 in all. Allocates nothing, unless copying a State does, at the
/// start alone.
template <Dynamics M, StepObserver<typename M::State> Observer>
void rk4(M& model, typename M::State& state, const TimeGrid& grid, Observer& observer) {
  typename M::State y = state, k = state, sum = state, stage = state;
  double t = grid.from;
  model.set_time(t);
  for (long i = 0;; ++i) {
    observer.arriving();
    model.rates(y, k);
    if (!observer.accepted(t, y, k) || i == grid.steps) {
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
  }
  state = y;
}

}  // namespace mbrt
