#pragma once
// Taylor series of high order: the method for tight tolerances. Order and step as Jorba and Zou have them (A software
// package for the numerical integration of ODEs by means of high-order Taylor methods, Experimental Mathematics 14,
// 2005); the coefficients come from emitted recurrences.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "mbrt/adaptive.hpp"
#include "mbrt/dop853.hpp"
#include "mbrt/math.hpp"
#include "mbrt/series.hpp"

namespace mbrt {

/// From this tolerance on the method is faster than dop853.
inline constexpr double tolerance_for_series = 1e-9;

/// At the step that a tolerance allows, terms of a series of this order fall by a factor of e^1.5 from one to the next.
/// Jorba and Zou (section 3) derive e^2 for a cost that grows with the square of the order; sums of vectors grow slower
/// (measured on orbits, chains and many bodies: up to a quarter faster than with e^2, and nowhere slower).
inline std::size_t order_for(double tolerance) {
  const double order = std::ceil(1 - 0.65 * std::log(tolerance));
  return static_cast<std::size_t>(std::clamp(order, 4.0, static_cast<double>(largest_order)));
}

/// The steps of the method: a `Stepper`. `M::Series` holds coefficients, its own or Coefficients.
///
/// Note [places without a series]: near a change of rank, and where a function has none, there is no series at a state.
/// Motions pass most such places smoothly, and so does a series that starts before them, if not too near: rounding
/// makes a pole there, whose part in the term of order k grows with the k-th power of step over distance. A step that
/// would end where islands are hard to solve is tried again much shorter, so that the next one may pass well beyond.
/// Where that does not help, steps are those of dop853. Their states are tried for a series, too, ever less often while
/// there is none: some scenes have one nowhere.
template <HasSeries M>
class TaylorStepper {
 public:
  using State = typename M::State;

  static constexpr bool needs_rate = false;

  /// For states of the size of `like`.
  explicit TaylorStepper(const State& like)
      : begin_(like),
        end_(like),
        rate_(like),
        carry_(like),
        begin_carry_(like),
        per_allowed_(like),
        fallback_(like),
        series_(1) {}

  State& state() { return end_; }
  State& rate() { return rate_; }
  const State& start() const { return begin_; }
  double step() const { return step_; }
  long evaluations() const { return evaluations_ + fallback_.evaluations(); }
  long fallbacks() const { return fallbacks_; }
  std::size_t worst_component() const { return fallback_.worst_component(); }

  void begin(M& model, const Task& task) {
    task_ = task;
    order_ = order_for(task.tolerance);
    expanded_ = end_;
    std::fill(carry_.begin(), carry_.end(), 0.0);
    may_lose_rank_ = false;
    if constexpr (Projectable<M>) {
      for (const auto& island : model.description().islands) {
        may_lose_rank_ = may_lose_rank_ || island.constraints.size() > 1;
      }
    }
  }

  Attempt attempt(M& model, double time, double to) {
    if (arrived_) {
      leave();
      choose(model, time, to);
    }
    return falls_back_ ? attempt_fallback(model, time, to) : advance(model, time, to);
  }

  void between(M& model, double time, State& y) {
    if (falls_back_) {
      fallback_.between(model, time, y);
      return;
    }
    sum_series(time - time_, y);
    for (std::size_t j = 0; j < y.size(); ++j) {
      y[j] += begin_[j];
    }
  }

 private:
  /// The end of the last step becomes the begin of the next one; what it was rounded by goes along unless somebody has
  /// moved it.
  void leave() {
    const std::size_t coordinates = std::min(task_.scales.coordinates, end_.size());
    for (std::size_t j = 0; j < coordinates; ++j) {
      per_allowed_[j] = 1 / (task_.tolerance * (task_.scales.length + std::abs(end_[j])));
    }
    for (std::size_t j = coordinates; j < end_.size(); ++j) {
      per_allowed_[j] = 1 / (task_.tolerance * (task_.scales.speed + std::abs(end_[j])));
    }
    for (std::size_t j = 0; j < end_.size(); ++j) {
      carry_[j] = end_[j] == expanded_[j] ? carry_[j] : 0;
    }
    begin_ = end_;
    begin_carry_ = carry_;
    arrived_ = false;
    shortened_ = 0;
  }

  /// The way to take the next step: Note [places without a series].
  void choose(M& model, double time, double to) {
    const bool fell_back = falls_back_;
    if (fell_back && waits_ > 0) {
      --waits_;
    } else {
      falls_back_ = !expand(model, time, to);
      waits_ = longest_wait_;
      longest_wait_ = falls_back_ ? std::min(2 * longest_wait_ + 1, 15) : 0;
    }
    if (falls_back_) {
      ++fallbacks_;
      model.set_time(time);
      fallback_.state() = begin_;
      model.rates(begin_, fallback_.rate());
      ++evaluations_;
      if (!fell_back) {
        begin_fallback(model, time, to);
      }
    }
  }

  bool expand(M& model, double time, double to) {
    ++evaluations_;
    model.set_time(time);  // an observer may have set another
    if (!model.expand(begin_, order_, series_[0])) {
      return false;
    }
    coefficients_ = coefficients_of(series_[0]);
    // A polynomial of low degree allows any step.
    step_ = std::min(allowed_length(), to - time);
    return end_before_switches(time) && time + 0.5 * step_ > time;  // not so where a coefficient is not finite
  }

  /// Shortens the step to end just behind the first switch. False for a start on one, which is on neither side.
  ///
  /// The argument p of a switch changes by at most L times the way, L the largest slope that its terms allow within the
  /// step: from t on it keeps its sign for |p(t)| / L at least. Going so far again and again approaches the first zero
  /// from below, and never passes one. Behind it the series of the old side is used for a hundredth of the tolerance of
  /// the step, which is far enough for the argument to have changed its sign.
  bool end_before_switches(double time) {
    ends_at_switch_ = false;
    for (std::size_t i = 0; i < coefficients_.switches.count; ++i) {
      if (coefficients_.switches.row(0)[i] == 0) {
        return false;
      }
      const double behind =
          0.01 * task_.tolerance * step_ + 4 * std::numeric_limits<double>::epsilon() * std::abs(time);
      const double zero = approach_zero(i, behind);
      if (zero < step_) {
        step_ = zero + behind;
        ends_at_switch_ = true;
      }
    }
    return true;
  }

  /// A time before the first zero of the argument of a switch, as near to it as `near` where the bound on its slope is
  /// sharp; the step's length if there is none within it.
  double approach_zero(std::size_t i, double near) const {
    constexpr int patience = 60;
    double slope = 0;
    for (std::size_t k = order_ - 1; k > 0; --k) {
      slope = slope * step_ + static_cast<double>(k) * std::abs(coefficients_.switches.row(k)[i]);
    }
    double at = 0;
    for (int n = 0; n < patience && at < step_; ++n) {
      double value = 0;
      for (std::size_t k = order_; k-- > 0;) {
        value = value * at + coefficients_.switches.row(k)[i];
      }
      const double way = std::abs(value) / slope;
      at += way;
      if (!(way > near)) {
        break;
      }
    }
    return std::min(at, step_);
  }

  static Coefficients coefficients_of(const Coefficients& series) { return series; }
  template <class Series>
  static Coefficients coefficients_of(const Series& series) {
    return series.coefficients();
  }

  /// The step at which the larger one of the terms of the last two orders is as large as is allowed; 0 where one is not
  /// finite.
  double allowed_length() const {
    const double* const last = coefficients_.state.row(order_);
    const double* const before = coefficients_.state.row(order_ - 1);
    double largest = 0, largest_before = 0, sum = 0;  // the sum meets what is not finite, which maxima may pass over
    for (std::size_t j = 0; j < begin_.size(); ++j) {
      const double size = std::abs(last[j]) * per_allowed_[j];
      const double size_before = std::abs(before[j]) * per_allowed_[j];
      largest = std::max(largest, size);
      largest_before = std::max(largest_before, size_before);
      sum += size + size_before;
    }
    const double order = static_cast<double>(order_);
    const double shortening = std::max(std::log2(largest) / order, std::log2(largest_before) / (order - 1));
    return std::isfinite(sum) ? std::exp2(-shortening) : 0;
  }

  Attempt advance(M& model, double time, double to) {
    const double end = ends_at_switch_ ? std::min(time + step_, to) : landing(time, step_, to);
    time_ = time;
    sum_series(end - time, end_);
    for (std::size_t j = 0; j < end_.size(); ++j) {
      const double change = end_[j] + begin_carry_[j];
      const double sum = begin_[j] + change;
      const double part = sum - begin_[j];
      carry_[j] = (begin_[j] - (sum - part)) + (change - part);  // the rounding error of the sum (Knuth)
      end_[j] = sum;
    }
    constexpr int most_shortenings = 3;
    if (may_lose_rank_ && shortened_ < most_shortenings && end < to && is_hard(model, end)) {
      ++shortened_;
      step_ = 0.4 * (end - time);
      return {end, 2};
    }
    expanded_ = end_;
    arrived_ = true;
    return {end, 1};
  }

  /// Whether an island is not solved the plain way at the step's end.
  [[gnu::noinline]] bool is_hard(M& model, double end) {
    if constexpr (Projectable<M>) {
      const long before = climbs(model);
      model.set_time(end);
      model.rates(end_, rate_);
      ++evaluations_;
      return climbs(model) != before;
    }
    return false;
  }

  /// y = sum of the terms behind the first, smallest first, those of even and of odd order in two sums.
  void sum_series(double h, State& y) const {
    const std::size_t size = y.size();
    const double square = h * h;
    const std::size_t highest_even = order_ / 2 * 2, highest_odd = (order_ - 1) / 2 * 2 + 1;
    for (std::size_t first = 0; first < size; first += lanes::width) {
      lanes::Vector even{}, odd{};
      for (std::size_t k = highest_even; k > 0; k -= 2) {
        even = even * square + lanes::load(coefficients_.state.row(k) + first);
      }
      for (std::size_t k = highest_odd + 2; k > 2; k -= 2) {
        odd = odd * square + lanes::load(coefficients_.state.row(k - 2) + first);
      }
      const lanes::Vector sum = even * square + odd * h;
      for (std::size_t j = first; j < std::min(first + lanes::width, size); ++j) {
        y[j] = sum[j - first];
      }
    }
  }

  void begin_fallback(M& model, double time, double to) {
    Task task = task_;
    task.from = time;
    task.to = to;
    fallback_.begin(model, task);
  }

  Attempt attempt_fallback(M& model, double time, double to) {
    const Attempt attempt = fallback_.attempt(model, time, to);
    end_ = fallback_.state();
    step_ = fallback_.step();
    if (attempt.error <= 1) {
      expanded_ = end_;
      std::fill(carry_.begin(), carry_.end(), 0.0);
      arrived_ = true;
      model.set_time(attempt.end);
      model.rates(end_, fallback_.rate());  // for its dense output
    }
    return attempt;
  }

  Task task_{};
  State begin_, end_;
  State expanded_;  ///< the end as it was computed
  State rate_;
  State carry_;        ///< what is missing in the state by rounding
  State begin_carry_;  ///< and in that at the begin of the step
  State per_allowed_;  ///< 1 / error that the tolerance allows in a component
  Dop853Stepper<State> fallback_;
  std::vector<typename M::Series> series_;  ///< one, on the heap: those of large models do not fit on every stack
  Coefficients coefficients_;               ///< in there
  std::size_t order_ = 0;
  double step_ = 0;
  double time_ = 0;  ///< where the series starts
  bool arrived_ = true;
  bool falls_back_ = false;
  bool ends_at_switch_ = false;
  bool may_lose_rank_ = false;
  int shortened_ = 0;     ///< how often this step was, for the sake of its end
  int waits_ = 0;         ///< steps to be left to dop853 before the next expansion is tried
  int longest_wait_ = 0;  ///< after an expansion that fails
  long evaluations_ = 0;  ///< and expansions; not those of dop853
  long fallbacks_ = 0;
};

/// The method, as `simulate` takes it.
struct Taylor {
  static constexpr const char* name = "taylor";

  template <HasSeries M, class Observer>
  static Course run(M& model, typename M::State& state, const Task& task, Observer& observer) {
    TaylorStepper<M> stepper(state);
    Course course = run_adaptively(model, state, task, stepper, observer);
    course.fallbacks = stepper.fallbacks();
    return course;
  }
};

}  // namespace mbrt
