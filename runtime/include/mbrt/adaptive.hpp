#pragma once
// The run of a method that chooses its steps.

#include <cmath>
#include <concepts>
#include <limits>

#include "mbrt/dynamics.hpp"

namespace mbrt {

/// One step that was tried: where it would end, and its error in parts of what the tolerance allows; up to 1 it is
/// accepted. NaN where a rate was not finite.
struct Attempt {
  double end;
  double error;
};

/// A method that chooses its steps, with the state that it has reached.
///
/// `state()` and `rate()` are those at the current time. The driver below evaluates the rate there, and may move the
/// state onto the constraints before. `begin` follows the first evaluation. `attempt` tries one step from there, not
/// beyond `to`; where its error is above 1 the next call tries a shorter one from the same state (`step()` long),
/// otherwise `state()` is the step's end. `between` interpolates over the last accepted step after the rate at its end
/// is known. `start()` is the state where that step, or the one that is being tried, begins.
template <class S, class M>
concept Stepper = requires(S& stepper, M& model, const Task& task, double time, typename M::State& state) {
  { stepper.state() } -> std::same_as<typename M::State&>;
  { stepper.rate() } -> std::same_as<typename M::State&>;
  { stepper.start() } -> std::same_as<const typename M::State&>;
  stepper.begin(model, task);
  { stepper.attempt(model, time, time) } -> std::same_as<Attempt>;
  stepper.between(model, time, state);
  { stepper.step() } -> std::same_as<double>;
  { stepper.evaluations() } -> std::same_as<long>;             // of its own
  { stepper.worst_component() } -> std::same_as<std::size_t>;  // of the last attempt
  { S::needs_rate } -> std::convertible_to<bool>;              // whether steps begin with rate()
};

/// Where a step of about `step` from `time` is to end: at `to` rather than just before it, and in two halves rather
/// than in a long and a short one.
inline double landing(double time, double step, double to) {
  const double rest = to - time;
  return step >= 0.99 * rest ? to : step > 0.5 * rest ? time + 0.5 * rest : time + step;
}

/// Moves `state` from task.from to task.to, or as far as it gets. Allocates nothing unless the stepper does.
template <Dynamics M, Stepper<M> S, class Observer>
Course run_adaptively(M& model, typename M::State& state, const Task& task, S& stepper, Observer& observer) {
  constexpr bool sees_rates = S::needs_rate || !std::same_as<Observer, Unobserved>;
  constexpr double too_small = 4 * std::numeric_limits<double>::epsilon();
  Course course;
  double t = task.from;
  const auto arrive = [&] {
    model.set_time(t);
    if constexpr (Projectable<M>) {
      if (task.project && course.steps > 0) {
        model.project(stepper.state());
        ++course.projections;
      }
    }
    observer.arriving();
    if constexpr (sees_rates) {
      model.rates(stepper.state(), stepper.rate());
      ++course.evaluations;
    }
  };
  stepper.state() = state;
  arrive();
  bool goes_on = observer.accepted(t, stepper.state(), stepper.rate());
  if (goes_on && t < task.to) {
    stepper.begin(model, task);
  }
  const auto stays = [&] {
    if constexpr (requires { stepper.stiff_from(); }) {
      return !task.leaves_stiff || std::isnan(stepper.stiff_from());
    } else {
      return true;
    }
  };
  while (goes_on && t < task.to && stays()) {
    const Attempt attempt = stepper.attempt(model, t, task.to);
    if (attempt.error <= 1) {
      t = attempt.end;
      ++course.steps;
      arrive();
      goes_on = observer.accepted(t, stepper.state(), stepper.rate(),
                                  [&](double at, typename M::State& y) { stepper.between(model, at, y); });
      continue;
    }
    ++course.rejected;
    if (!(stepper.step() > std::max(too_small * std::abs(t), std::numeric_limits<double>::min()))) {
      course.ending = std::isfinite(attempt.error) ? Ending::StepTooSmall : Ending::NotFinite;
      course.failed_step = attempt.end - t;
      course.component = stepper.worst_component();
      stepper.state() = stepper.start();
      break;
    }
  }
  if (course.ending == Ending::Complete && t < task.to) {
    course.ending = goes_on ? Ending::Stiff : Ending::Stopped;
  }
  course.time = t;
  course.evaluations += stepper.evaluations();
  state = stepper.state();
  return course;
}

}  // namespace mbrt
