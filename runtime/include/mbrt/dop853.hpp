#pragma once
// The Runge-Kutta method of Dormand and Prince of order 8, with error estimates of order 5 and 3 and dense output of
// order 7: Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, sections II.4 to II.6.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "mbrt/adaptive.hpp"
#include "mbrt/dop853_coefficients.hpp"
#include "mbrt/math.hpp"

namespace mbrt {

/// The steps of the method: a `Stepper` for any Dynamics of this State.
template <class State>
class Dop853Stepper {
 public:
  static constexpr bool needs_rate = true;

  /// For states of the size of `like`.
  explicit Dop853Stepper(const State& like) : begin_(like), end_(like), allowed_(like) {
    for (State& k : k_) {
      k = like;
    }
    for (State& coefficients : dense_) {
      coefficients = like;
    }
  }

  State& state() { return end_; }
  State& rate() { return k_[dop853::stages]; }
  const State& start() const { return begin_; }
  double step() const { return step_; }
  long evaluations() const { return evaluations_; }
  /// When the motion was found to be stiff: NaN if it was not.
  double stiff_from() const { return stiff_from_; }

  template <Dynamics M>
  void begin(M& model, const Task& task) {
    tolerance_ = task.tolerance;
    may_project_ = task.project;
    for (std::size_t j = 0; j < allowed_.size(); ++j) {
      allowed_[j] = task.tolerance * task.scales.of(j);
    }
    leave();
    choose_first_step(model, task);
  }

  /// Not inlined: compiled once for all observers.
  template <Dynamics M>
  [[gnu::noinline]] Attempt attempt(M& model, double time, double to) {
    if (arrived_) {
      watch_stability();
      leave();
    }
    const double end = landing(time, step_, to);
    const double h = end - time;
    time_ = time;
    end_time_ = end;
    tried_step_ = h;
    if (projects_stages_) {
      projected_stages(model);
    } else {
      [&]<std::size_t... S>(std::index_sequence<S...>) { (stage<S + 1>(model), ...); }
      (std::make_index_sequence<dop853::stages - 1>{});
    }
    advance<dop853::stages>(h);
    const double error = estimate_error(h);
    control(h, error);
    if constexpr (Projectable<M>) {
      watch_rank(model);
    }
    return {end, error};
  }

  /// Three evaluations for the first call in a step.
  template <Dynamics M>
  void between(M& model, double time, State& y) {
    if (!dense_is_ready_) {
      prepare_dense(model);
    }
    const double s = (time - time_) / tried_step_;
    const double r = 1 - s;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double difference = end_[j] - begin_[j];
      const double at_begin = tried_step_ * k_[0][j] - difference;
      const double at_end = difference - tried_step_ * k_[dop853::stages][j] - at_begin;
      const double upper = dense_[0][j] + s * (dense_[1][j] + r * (dense_[2][j] + s * dense_[3][j]));
      y[j] = begin_[j] + s * (difference + r * (at_begin + s * (at_end + r * upper)));
    }
  }

  std::size_t worst_component() const {
    std::size_t worst = 0;
    double largest = -1;
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      const double error = std::abs(sum<dop853::FifthOrderError>(j)) / allowed(j);
      if (std::isnan(error)) {
        return j;
      }
      if (error > largest) {
        largest = error;
        worst = j;
      }
    }
    return worst;
  }

 private:
  /// The step's end becomes the begin of the next one.
  void leave() {
    begin_ = end_;
    k_[0] = k_[dop853::stages];
    arrived_ = false;
    dense_is_ready_ = false;
  }

  /// One component of a sum over stages, without the terms that are zero.
  template <class Row>
  [[gnu::always_inline]] double sum(std::size_t j) const {
    double total = 0;
    [&]<std::size_t... I>(std::index_sequence<I...>) { (add_term<Row, I>(total, j), ...); }
    (std::make_index_sequence<Row::count>{});
    return total;
  }

  template <class Row, std::size_t I>
  [[gnu::always_inline]] void add_term(double& total, std::size_t j) const {
    if constexpr (Row::at(I) != 0) {
      total += Row::at(I) * k_[I][j];
    }
  }

  template <std::size_t Stage>
  double time_of() const {
    return dop853::nodes[Stage] == 1 ? end_time_ : time_ + dop853::nodes[Stage] * tried_step_;
  }

  template <std::size_t Stage>
  void advance(double h) {
    for_each_component(end_, [&](std::size_t j) { end_[j] = begin_[j] + h * sum<dop853::StageSum<Stage>>(j); });
  }

  /// For evaluations that are rare: rates() and project() may be code that is large and inlined.
  template <Dynamics M>
  [[gnu::noinline]] void evaluate(M& model, double time, State& rate) {
    model.set_time(time);
    if constexpr (Projectable<M>) {
      if (projects_stages_) {
        model.project(end_);
      }
    }
    model.rates(end_, rate);
    ++evaluations_;
  }

  template <std::size_t Stage, Dynamics M>
  void rare_stage(M& model) {
    for (std::size_t j = 0; j < end_.size(); ++j) {
      end_[j] = begin_[j] + tried_step_ * sum<dop853::StageSum<Stage>>(j);
    }
    evaluate(model, time_of<Stage>(), k_[Stage]);
  }

  template <std::size_t Row>
  void dense_row() {
    for (std::size_t j = 0; j < end_.size(); ++j) {
      dense_[Row][j] = tried_step_ * sum<dop853::DenseSum<Row>>(j);
    }
  }

  template <std::size_t Stage, Dynamics M>
  void stage(M& model) {
    advance<Stage>(tried_step_);
    model.set_time(time_of<Stage>());
    model.rates(end_, k_[Stage]);
    ++evaluations_;
  }

  /// Note [projected stages]: stages are off the constraints, by a low power of the step. Near a singular position, at
  /// a smallest singular value s of the constraints, that changes the rates by its s-th part or more, so that steps
  /// would become ever shorter on the way there. The rates at the states projected onto the constraints, f(P(y)), are
  /// those of the same motion, and remain smooth; a method keeps its order when it takes them for f. A step that was
  /// rejected while islands were hard to solve is therefore tried again with them. Rounding remains: P is known to
  /// eps/s along the motion that is lost at s = 0, the rates to eps/s^2. A step passes if none of its stages comes too
  /// near; the widest gaps between their times are a quarter of it. While stages are projected, steps that are rejected
  /// therefore shrink little by little, so that a singular position comes to lie in these gaps, before they shrink for
  /// good. Tight tolerances may find no such step, and say so (one and two four-bars, sixty starts: all pass down to
  /// 1e-10, all but two at 1e-11 and at 1e-12, five of six at 1e-13).
  template <Dynamics M>
  [[gnu::noinline]] void projected_stages(M& model) {
    [&]<std::size_t... S>(std::index_sequence<S...>) { (rare_stage<S + 1>(model), ...); }
    (std::make_index_sequence<dop853::stages - 1>{});
  }

  template <Projectable M>
  void watch_rank(M& model) {
    if (arrived_ || !may_project_) {
      projects_stages_ = false;
      return;
    }
    const long now = climbs(model);
    if (!projects_stages_ && now != climbs_) {
      projects_stages_ = true;
      step_ = tried_step_;
    }
    climbs_ = now;
  }

  /// Looks now and then whether steps are as long as stability allows, and closer while it seems so: Hairer and Wanner,
  /// volume II, section IV.2.
  void watch_stability() {
    constexpr int steps_between = 16, enough = 15, forgotten_after = 6;
    if (std::isnan(stiff_from_) && (suspicions_ > 0 || ++unwatched_ == steps_between)) {
      unwatched_ = 0;
      if (is_bound_by_stability()) {
        calm_ = 0;
        stiff_from_ = ++suspicions_ == enough ? end_time_ : stiff_from_;
      } else if (++calm_ == forgotten_after) {
        calm_ = suspicions_ = 0;
      }
    }
  }

  /// The last stage and the end of a step are at one time and near each other: the difference of their rates over that
  /// of their states estimates the largest eigenvalue. The method is stable up to 6.1 of it over a step.
  [[gnu::noinline]] bool is_bound_by_stability() const {
    constexpr std::size_t last = dop853::stages - 1;
    double of_rates = 0, of_states = 0;
    for (std::size_t j = 0; j < end_.size(); ++j) {
      const double rate = k_[dop853::stages][j] - k_[last][j];
      const double state = end_[j] - begin_[j] - tried_step_ * sum<dop853::StageSum<last>>(j);
      of_rates += rate * rate;
      of_states += state * state;
    }
    constexpr double stable = 6.1;
    return of_states > 0 && tried_step_ * tried_step_ * of_rates > stable * stable * of_states;
  }

  double allowed(std::size_t j) const {
    return allowed_[j] + tolerance_ * std::max(std::abs(begin_[j]), std::abs(end_[j]));
  }

  /// The largest error of order 5 in parts of what is allowed, brought to order 7 by its ratio to that of order 3
  /// (section II.10 of the book).
  double estimate_error(double h) const {
    double fifth = 0, third = 0;
    for_each_component(begin_, [&](std::size_t j) {
      const double per_allowed = 1 / allowed(j);
      fifth = max(fifth, std::abs(sum<dop853::FifthOrderError>(j)) * per_allowed);
      third = max(third, std::abs(sum<dop853::ThirdOrderError>(j)) * per_allowed);
    });
    return fifth == 0 ? 0 : h * fifth * fifth / std::sqrt(fifth * fifth + 0.01 * third * third);
  }

  /// The next step from the last one and its error, and a little from the error before (section IV.2 in volume II).
  /// Measured on orbits, many bodies and linkages: 13 % fewer evaluations for an error than with 0.9 and 1/64.
  void control(double h, double error) {
    constexpr double safety = 0.8, shrinks_most = 0.2, grows_most = 6;
    constexpr double weight_of_last = 1.0 / 32, exponent = 1.0 / 8 - weight_of_last;
    if (!std::isfinite(error)) {
      step_ = 0.1 * h;
    } else if (error > 1) {
      constexpr double shrinks_gently = 0.93;
      constexpr int patience = 32;  // to a tenth
      const bool is_gentle = projects_stages_ && gentle_rejections_++ < patience;
      step_ = h * std::max(is_gentle ? shrinks_gently : shrinks_most, safety * std::pow(error, -1.0 / 8));
    } else {
      const double factor = safety * std::pow(error, -exponent) * std::pow(last_error_, weight_of_last);
      step_ = h * std::clamp(factor, shrinks_most, shrunk_ ? 1 : grows_most);
      last_error_ = std::max(error, 1e-4);
      arrived_ = true;
      gentle_rejections_ = 0;
    }
    shrunk_ = !arrived_;
  }

  /// A step at whose end a step of Euler's method, and the change of the rate over it, say that the error of order 8
  /// is about 0.01 (section II.4).
  template <Dynamics M>
  [[gnu::noinline]] void choose_first_step(M& model, const Task& task) {
    const auto size = [this](const State& values) {
      double largest = 0;
      for (std::size_t j = 0; j < values.size(); ++j) {
        largest = max(largest, std::abs(values[j]) / allowed(j));
      }
      return largest;
    };
    constexpr double little = 1e-5;
    const double of_state = size(begin_);
    const double of_rate = size(k_[0]);
    const double span = task.to - task.from;
    const double first =
        std::min(span, of_state < little || of_rate < little ? 1e-6 * span : 0.01 * of_state / of_rate);
    for (std::size_t j = 0; j < end_.size(); ++j) {
      end_[j] = begin_[j] + first * k_[0][j];
    }
    evaluate(model, task.from + first, k_[1]);
    for (std::size_t j = 0; j < end_.size(); ++j) {
      k_[1][j] -= k_[0][j];
    }
    const double derivative = std::max(of_rate, size(k_[1]) / first);
    const double second = derivative > 0 ? std::pow(0.01 / derivative, 1.0 / 8) : span;
    step_ = std::isfinite(second) ? std::min({100 * first, second, span}) : first;
  }

  template <Dynamics M>
  [[gnu::noinline]] void prepare_dense(M& model) {
    const State kept = end_;
    rare_stage<dop853::stages + 1>(model);
    rare_stage<dop853::stages + 2>(model);
    rare_stage<dop853::stages + 3>(model);
    end_ = kept;
    dense_row<0>();
    dense_row<1>();
    dense_row<2>();
    dense_row<3>();
    dense_is_ready_ = true;
  }

  State begin_;  // of the step
  State end_;    // of the step, and the stages on the way
  std::array<State, dop853::all_stages> k_;
  std::array<State, 4> dense_;
  State allowed_;  // the constant part of what the tolerance allows
  double tolerance_ = 0;
  double step_ = 0;        // next to try
  double time_ = 0;        // where the step begins
  double end_time_ = 0;    // and ends
  double tried_step_ = 0;  // its length
  double last_error_ = 1e-4;
  bool arrived_ = false;  // the last attempt was accepted
  bool shrunk_ = false;   // and the one before was not
  bool may_project_ = false;
  bool projects_stages_ = false;  // Note [projected stages]
  int gentle_rejections_ = 0;     // likewise
  long climbs_ = 0;               // of the model, when a step was last rejected
  bool dense_is_ready_ = false;
  int unwatched_ = 0;   // steps since stability was looked at
  int suspicions_ = 0;  // steps that it seemed to bound
  int calm_ = 0;        // and not, since the last of them
  double stiff_from_ = std::numeric_limits<double>::quiet_NaN();
  long evaluations_ = 0;
};

/// The method by its name, for `simulate` (simulation.hpp).
struct Dop853 {
  static constexpr const char* name = "dop853";
  static constexpr std::size_t most_bytes_on_stack = std::size_t{1} << 18;

  /// Moves `state` as `task` says.
  template <Dynamics M, class Observer>
  static Course run(M& model, typename M::State& state, const Task& task, Observer& observer) {
    using Steps = Dop853Stepper<typename M::State>;
    if constexpr (sizeof(Steps) > most_bytes_on_stack) {
      std::vector<Steps> steps;
      steps.emplace_back(state);
      return run(model, state, task, observer, steps.front());
    } else {
      Steps steps(state);
      return run(model, state, task, observer, steps);
    }
  }

 private:
  template <Dynamics M, class Observer>
  static Course run(M& model, typename M::State& state, const Task& task, Observer& observer,
                    Dop853Stepper<typename M::State>& steps) {
    Course course = run_adaptively(model, state, task, steps, observer);
    course.stiff_from = steps.stiff_from();
    return course;
  }
};

}  // namespace mbrt
