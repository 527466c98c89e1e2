#pragma once
// What integrators and those who use them know of each other.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>

namespace mbrt {

/// A first-order system y' = f(t, y). `State` is an indexable range of doubles; the time is set before `rates`.
template <class M>
concept Dynamics = requires(M& model, const typename M::State& state, typename M::State& rate, double time) {
  model.set_time(time);
  model.rates(state, rate);
};

/// Dynamics that can be moved onto the constraints of its motion, at the time set, and whose islands tell how hard they
/// were to solve.
template <class M>
concept Projectable = Dynamics<M> && requires(M& model, typename M::State& state) {
  model.project(state);
  model.island(0).record->pinv + model.island(0).record->refined;
  model.description().islands.size();
};

/// Dynamics with derivatives: `change` becomes that of rates(y) along `direction`, a state, at the time set. False
/// where there is none that is accurate enough.
template <class M>
concept HasTangent = Dynamics<M> &&
    requires(M& model, const typename M::State& y, const typename M::State& direction, typename M::State& change) {
  { model.tangent(y, direction, change) } -> std::convertible_to<bool>;
};

/// How often islands were not solved the plain way so far: Note [rank ladder] in island.hpp.
template <Projectable M>
long climbs(M& model) {
  long sum = 0;
  for (std::size_t k = 0; k < model.description().islands.size(); ++k) {
    const auto& record = *model.island(static_cast<int>(k)).record;
    sum += record.refined + record.pinv;
  }
  return sum;
}

/// Sees each state that a method accepts, the start included. `arriving` is called before the rate there is evaluated,
/// `accepted` after it, with the model's time set to `time`; it may set another, and false ends the run. Methods with
/// dense output pass a fourth argument: `between(at, y)` makes y the state at any time of the step that ends at `time`.
template <class O, class State>
concept StepObserver = requires(O& observer, double time, const State& state) {
  observer.arriving();
  { observer.accepted(time, state, state) } -> std::convertible_to<bool>;
};

/// The observer of a run of which only the end is wanted.
struct Unobserved {
  void arriving() {}
  template <class... Anything>
  bool accepted(const Anything&...) {
    return true;
  }
};

/// Sizes that errors are compared with: of the first so many components of a state (coordinates), and of the rest
/// (speeds).
struct Scales {
  std::size_t coordinates = 0;
  double length = 1;
  double speed = 1;

  double of(std::size_t component) const { return component < coordinates ? length : speed; }
};

/// The scales of a start: the largest coordinate Q and the largest speed U, or for a start at rest the speed that the
/// largest acceleration A gives over Q; for one at the origin the way U^2/A on which A changes U. They change with the
/// units as the state does. What the start says nothing about is 1.
inline Scales scales_of(std::span<const double> state, std::span<const double> rate, std::size_t coordinates) {
  const auto largest = [](std::span<const double> values) {
    double size = 0;
    for (const double value : values) {
      size = std::max(size, std::abs(value));
    }
    return size;
  };
  const double q = largest(state.first(coordinates));
  const double u = largest(state.subspan(coordinates));
  const double a = largest(rate.subspan(coordinates));
  const double speed = std::max(u, std::sqrt(a * q));
  const double length = q > 0 ? q : u * u / a;  // NaN or infinite where both are at rest
  const auto or_one = [](double size) { return size > 0 && std::isfinite(size) ? size : 1; };
  return {coordinates, or_one(length), or_one(speed)};
}

/// What an integration is to do. `step` is for methods of constant step; `tolerance` and `scales` for those that choose
/// theirs, so that each step's error in component i is at most tolerance * (scales.of(i) + |y_i|).
struct Task {
  double from;
  double to;
  double step;
  double tolerance;
  Scales scales;
  bool project;               ///< moves every accepted state onto the constraints
  bool leaves_stiff = false;  ///< ends where a method finds out that the motion is too stiff for it
};

enum class Ending {
  Complete,      ///< at Task::to
  Stopped,       ///< by the observer
  Stiff,         ///< as Task::leaves_stiff asks for
  StepTooSmall,  ///< no step that the time can still resolve meets the tolerance
  NotFinite,     ///< every step meets a rate that is not a finite number
};

/// What an integration did.
struct Course {
  Ending ending = Ending::Complete;
  double time = 0;            ///< of the last accepted state
  double failed_step = 0;     ///< the last one tried from there, where it ends in failure
  std::size_t component = 0;  ///< of the state, whose error was then the largest
  long steps = 0;             ///< accepted
  long rejected = 0;
  long evaluations = 0;
  long projections = 0;
  long fallbacks = 0;  ///< of the steps, those that a method left to another one
  double stiff_from = std::numeric_limits<double>::quiet_NaN();  ///< from when on stability bounded explicit steps
  long jacobians = 0;                                            ///< taken by an implicit method
  long differenced = 0;                                          ///< of those, by differences of rates
  long factorisations = 0;                                       ///< of its systems: a real one and a complex one each
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

}  // namespace mbrt
