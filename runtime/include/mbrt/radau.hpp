#pragma once
// The implicit Runge-Kutta method Radau IIA of order 5, for stiff motions: Hairer and Wanner, Solving Ordinary
// Differential Equations II, section IV.8, from which the equations are, unless others are named.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mbrt/adaptive.hpp"
#include "mbrt/collocation.hpp"
#include "mbrt/jacobian.hpp"
#include "mbrt/radau_coefficients.hpp"

namespace mbrt {

/// The steps of the method: a `Stepper` for any Dynamics. Jacobian and factorisation are kept as long as Newton's
/// method converges quickly with them.
///
/// Allocates when it is made; for large states also in a factorisation.
template <Dynamics M>
class RadauStepper {
 public:
  using State = typename M::State;

  static constexpr bool needs_rate = true;

  /// For states of the size of `like`.
  explicit RadauStepper(const State& like)
      : begin_(like),
        end_(like),
        begin_rate_(like),
        rate_(like),
        stage_(like),
        defect_(like),
        error_(like),
        per_allowed_(like),
        collocation_(like),
        jacobian_(like) {
    for (auto* const states : {&z_, &w_, &k_}) {
      states->fill(like);
    }
  }

  State& state() { return end_; }
  State& rate() { return rate_; }
  const State& start() const { return begin_; }
  double step() const { return step_; }
  long evaluations() const { return evaluations_ + jacobian_.evaluations(); }
  const Jacobian<M>& jacobian() const { return jacobian_; }
  std::size_t worst_component() const { return worst_; }

  void begin(M& /*model*/, const Task& task) {
    task_ = task;
    allowed_ = 0.1 * std::pow(task.tolerance, 2.0 / 3);
    newton_error_ = std::max(10 * eps / allowed_, std::min(0.03, std::sqrt(allowed_)));
    leave();
    collocation_.start(rate_);
    choose_first_step();
  }

  /// Not inlined: compiled once for all observers.
  [[gnu::noinline]] Attempt attempt(M& model, double time, double to) {
    if (arrived_) {
      take_step();
      leave();
    }
    const double end = landing(time, step_, to);
    const double h = end - time;
    if (!jacobian_.prepare(model, task_, time, h, begin_, begin_rate_)) {
      step_ = 0.1 * h;
      return {end, not_a_number};
    }
    predict(h);
    const Convergence convergence = iterate(model, time, end);
    if (convergence != Convergence::Reached) {
      return give_up(convergence, h, end);
    }
    const double error = estimate_error(model, time, h);
    control(h, error);
    return {end, error};
  }

  /// Of order 3; of a component and the one that it follows more is known, so that both are of order 5. Ends at
  /// state(), wherever that was moved.
  void between(M& /*model*/, double time, State& y) {
    take_step();
    const double s = (time - time_) / tried_step_;
    for (std::size_t j = 0; j < y.size(); ++j) {
      y[j] = begin_[j] + collocation_(s, j);
    }
    for (const Follower& follower : jacobian_.systems().followers()) {
      const auto [q, u] = follower;
      if (begin_rate_[q] == begin_[u] && rate_[q] == end_[u]) {
        const auto pair = collocation_.between(s, {begin_[q], begin_[u]}, {end_[q], end_[u]}, u);
        y[q] = pair.coordinate;
        y[u] = pair.speed;
      }
    }
  }

 private:
  enum class Convergence { Reached, Slow, NotFinite };

  static constexpr double eps = std::numeric_limits<double>::epsilon();
  static constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  static constexpr int most_iterations = 7;
  static constexpr double safety = 0.9;

  /// The step's end becomes the begin of the next one.
  void leave() {
    begin_ = end_;
    begin_rate_ = rate_;
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      per_allowed_[j] = 1 / (allowed_ * (task_.scales.of(j) + std::abs(begin_[j])));
    }
    arrived_ = is_taken_ = false;
  }

  /// The largest component in parts of what is allowed; NaN if one is.
  double size(const State& values) {
    double largest = 0;
    for (std::size_t j = 0; j < values.size(); ++j) {
      const double part = std::abs(values[j]) * per_allowed_[j];
      if (!(part <= largest)) {
        largest = part;
        worst_ = j;
        if (std::isnan(part)) {
          break;
        }
      }
    }
    return largest;
  }

  /// The way of a step of Euler's method is a hundredth of the state, or where there is little of either the step is a
  /// millionth of the run: the control of the step finds its way from there.
  void choose_first_step() {
    constexpr double little = 1e-5;
    const double span = task_.to - task_.from;
    const double of_state = size(begin_), of_rate = size(begin_rate_);
    step_ = std::min(span, of_state < little || of_rate < little ? 1e-6 * span : 0.01 * of_state / of_rate);
  }

  /// The stages, less the begin, from the polynomial of the step before; 0 if there is none.
  void predict(double h) {
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      std::array<double, radau::stages> z{};
      for (std::size_t i = 0; i < radau::stages && follows_; ++i) {
        z[i] = collocation_(1 + radau::nodes[i] * h / collocation_.length(), j) - collocation_(1, j);
      }
      for (std::size_t i = 0; i < radau::stages; ++i) {
        z_[i][j] = z[i];
        w_[i][j] = product(radau::to_blocks[i], z);
      }
    }
  }

  static double product(const std::array<double, radau::stages>& row, const std::array<double, radau::stages>& x) {
    return row[0] * x[0] + row[1] * x[1] + row[2] * x[2];
  }

  /// Newton's method for the stages, equation (8.13), until what is left is small against the tolerance (8.10).
  Convergence iterate(M& model, double time, double end) {
    double last = 0, last_ratio = 1;
    contraction_ = 0;  // of a single iteration nothing is known, and nothing is wrong with it
    double factor = std::pow(std::max(contraction_factor_, eps), 0.8);
    for (iterations_ = 1; iterations_ <= most_iterations; ++iterations_) {
      if (!evaluate_stages(model, time, end)) {
        return Convergence::NotFinite;
      }
      const double change = improve(end - time);
      if (iterations_ > 1) {
        const double ratio = change / last;
        contraction_ = iterations_ == 2 ? ratio : std::sqrt(ratio * last_ratio);
        last_ratio = ratio;
        if (!(contraction_ < 0.99)) {
          shortening_ = 0.5;
          return Convergence::Slow;
        }
        factor = contraction_ / (1 - contraction_);
        const int left = most_iterations - iterations_;
        const double expected = factor * change * std::pow(contraction_, left) / newton_error_;
        if (expected >= 1) {
          shortening_ = 0.8 * std::pow(std::clamp(expected, 1e-4, 20.0), -1.0 / (4 + left));
          return Convergence::Slow;
        }
      }
      last = std::max(change, eps);
      if (factor * change <= newton_error_) {
        contraction_factor_ = factor;
        return Convergence::Reached;
      }
    }
    shortening_ = 0.5;
    return Convergence::Slow;
  }

  bool evaluate_stages(M& model, double time, double end) {
    double sum = 0;  // meets what is not finite
    for (std::size_t i = 0; i < radau::stages; ++i) {
      for (std::size_t j = 0; j < stage_.size(); ++j) {
        stage_[j] = begin_[j] + z_[i][j];
      }
      model.set_time(i + 1 == radau::stages ? end : time + radau::nodes[i] * (end - time));
      model.rates(stage_, k_[i]);
      ++evaluations_;
      for (const double rate : k_[i]) {
        sum += rate;
      }
    }
    return std::isfinite(sum);
  }

  /// One step of Newton's method; its size.
  double improve(double h) {
    const double real = radau::real_eigenvalue / h;
    const double alpha = radau::eigenvalue.real / h, beta = radau::eigenvalue.imaginary / h;
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      const std::array k = {k_[0][j], k_[1][j], k_[2][j]};
      k_[0][j] = product(radau::to_blocks[0], k) - real * w_[0][j];
      k_[1][j] = product(radau::to_blocks[1], k) - (alpha * w_[1][j] - beta * w_[2][j]);
      k_[2][j] = product(radau::to_blocks[2], k) - (beta * w_[1][j] + alpha * w_[2][j]);
    }
    jacobian_.systems().solve(k_[0]);
    jacobian_.systems().solve(k_[1], k_[2]);
    double square = 0;
    for (std::size_t i = 0; i < radau::stages; ++i) {
      const double change = size(k_[i]);
      square += change * change;
    }
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      for (std::size_t i = 0; i < radau::stages; ++i) {
        w_[i][j] += k_[i][j];
      }
      const std::array w = {w_[0][j], w_[1][j], w_[2][j]};
      for (std::size_t i = 0; i < radau::stages; ++i) {
        z_[i][j] = product(radau::from_blocks[i], w);
      }
    }
    return std::sqrt(square);
  }

  Attempt give_up(Convergence convergence, double h, double end) {
    const bool finite = convergence != Convergence::NotFinite;
    step_ = (finite ? shortening_ : 0.1) * h;
    jacobian_.expire();
    rejected_ = true;
    return {end, finite ? std::numeric_limits<double>::max() : not_a_number};
  }

  /// The difference to an embedded formula of order 3, kept bounded for stiff components (8.19); where it rejects a
  /// step at the start or behind a rejected one, the better one (8.20).
  double estimate_error(M& model, double time, double h) {
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      defect_[j] = product(radau::error_weights, {z_[0][j], z_[1][j], z_[2][j]}) / h;
      error_[j] = defect_[j] + begin_rate_[j];
      end_[j] = begin_[j] + z_[2][j];
    }
    jacobian_.systems().solve(error_);
    double error = size(error_);
    if (error >= 1 && (rejected_ || !follows_)) {
      for (std::size_t j = 0; j < begin_.size(); ++j) {
        stage_[j] = begin_[j] + error_[j];
      }
      model.set_time(time);
      model.rates(stage_, error_);
      ++evaluations_;
      for (std::size_t j = 0; j < begin_.size(); ++j) {
        error_[j] += defect_[j];
      }
      jacobian_.systems().solve(error_);
      error = size(error_);
    }
    time_ = time;
    tried_step_ = h;
    return error;
  }

  /// The next step from the error and the work of Newton's method (8.21), and from the error before (8.25), whichever
  /// is shorter. One that would be but a little longer stays, for the sake of the factorisation.
  void control(double h, double error) {
    constexpr double grows_most = 8, shrinks_most = 0.2, little = 1.2;
    const double careful = safety * (1 + 2 * most_iterations) / (iterations_ + 2 * most_iterations);
    const auto bounded = [=](double factor) { return std::clamp(factor, shrinks_most, grows_most); };
    if (!std::isfinite(error)) {
      step_ = 0.1 * h;
    } else if (error > 1) {
      step_ = follows_ ? h * bounded(careful * std::pow(error, -0.25)) : 0.1 * h;
    } else {
      const double small = std::max(error, 1e-10);
      double factor = bounded(careful * std::pow(small, -0.25));
      if (follows_) {
        const double predicted = safety * h / collocation_.length() * std::pow(last_error_ / (small * small), 0.25);
        factor = std::min(factor, bounded(predicted));
      }
      factor = rejected_ ? std::min(factor, 1.0) : factor;
      const bool stays = jacobian_.serves(contraction_) && factor >= 1 && factor <= little;
      step_ = stays ? h : h * factor;
      last_error_ = std::max(small, 1e-2);
      arrived_ = follows_ = true;
    }
    rejected_ = !arrived_;
  }

  /// What collocation_ knows of the step that was accepted, once its end is where it stays.
  void take_step() {
    if (!is_taken_) {
      collocation_.take(z_, begin_, end_, tried_step_);
      is_taken_ = true;
    }
  }

  Task task_{};
  State begin_, end_;
  State begin_rate_, rate_;
  State stage_;
  State defect_, error_;
  State per_allowed_;                   ///< 1 / error that the tolerance allows in a component
  std::array<State, radau::stages> z_;  ///< stages, less the begin
  std::array<State, radau::stages> w_;  ///< z in blocks: z = T w
  std::array<State, radau::stages> k_;  ///< rates of the stages, then changes of w
  Collocation<State> collocation_;      ///< of the last step
  Jacobian<M> jacobian_;
  double allowed_ = 0;       ///< the tolerance of an error estimate of order 3
  double newton_error_ = 0;  ///< and of Newton's method, in parts of that
  double step_ = 0;          ///< next to try
  double time_ = 0;          ///< where the last one that converged begins
  double tried_step_ = 0;    ///< and its length
  double last_error_ = 0;
  double contraction_ = 0;         ///< of Newton's method, from one change to the next
  double contraction_factor_ = 1;  ///< what is left in parts of the last change
  double shortening_ = 0.5;        ///< of a step in which it is too slow
  int iterations_ = 0;
  std::size_t worst_ = 0;
  bool arrived_ = false;   ///< the last attempt was accepted
  bool follows_ = false;   ///< a step was accepted
  bool rejected_ = false;  ///< the last attempt was not accepted
  bool is_taken_ = false;  ///< by collocation_
  long evaluations_ = 0;
};

/// The method, as `simulate` takes it.
struct Radau {
  static constexpr const char* name = "radau";

  template <Dynamics M, class Observer>
  static Course run(M& model, typename M::State& state, const Task& task, Observer& observer) {
    std::vector<RadauStepper<M>> steppers;  // one, on the heap: those of large models do not fit on every stack
    RadauStepper<M>& stepper = steppers.emplace_back(state);
    Course course = run_adaptively(model, state, task, stepper, observer);
    course.jacobians = stepper.jacobian().taken();
    course.differenced = stepper.jacobian().differenced();
    course.factorisations = stepper.jacobian().factorisations();
    return course;
  }
};

}  // namespace mbrt
