#pragma once
// The Jacobian of a right-hand side, taken when it is needed anew, and the factorisations of an implicit method.

#include <algorithm>
#include <cmath>
#include <limits>

#include "mbrt/dynamics.hpp"
#include "mbrt/radau_coefficients.hpp"
#include "mbrt/stage_systems.hpp"

namespace mbrt {

/// d rates / d state, column by column: from emitted code where the model has it and it is safe there, else by
/// differences. Newton's method needs it for its speed, not for its accuracy.
template <Dynamics M>
class Jacobian {
 public:
  using State = typename M::State;

  /// For states of the size of `like`.
  explicit Jacobian(const State& like) : systems_(like.size()), direction_(like), change_(like) {}

  StageSystems& systems() { return systems_; }
  long taken() const { return taken_; }
  long differenced() const { return differenced_; }
  long factorisations() const { return factorisations_; }
  long evaluations() const { return evaluations_; }

  /// Makes the systems those of a step of length h from `time` and `y`, whose rate is `rate`, as far as they are not;
  /// false where a derivative is not finite.
  bool prepare(M& model, const Task& task, double time, double h, const State& y, const State& rate) {
    if (!is_valid_) {
      model.set_time(time);
      take(model, task, y, rate);
      factored_step_ = 0;
      is_valid_ = is_current_ = systems_.take_jacobian();
      if (!is_valid_) {
        return false;
      }
    }
    // What rounding makes of a step does not matter.
    if (!(std::abs(h - factored_step_) <= 1e-9 * h)) {
      systems_.factorise(radau::real_eigenvalue / h, {radau::eigenvalue.real / h, radau::eigenvalue.imaginary / h});
      factored_step_ = h;
      ++factorisations_;
    }
    return true;
  }

  /// After an accepted step: whether it serves for the next one, with this contraction of Newton's method. The bound is
  /// that of the book for Jacobians that cost a few evaluations.
  bool serves(double contraction) {
    is_current_ = false;
    is_valid_ = contraction <= 1e-3;
    return is_valid_;
  }

  /// After a rejected step: one that was taken elsewhere is to blame.
  void expire() { is_valid_ = is_current_; }

 private:
  void take(M& model, const Task& task, const State& y, const State& rate) {
    ++taken_;
    if (!by_code(model, y)) {
      ++differenced_;
      by_differences(model, task, y, rate);
    }
  }

  bool by_code([[maybe_unused]] M& model, [[maybe_unused]] const State& y) {
    if constexpr (HasTangent<M>) {
      for (std::size_t j = 0; j < y.size(); ++j) {
        std::fill(direction_.begin(), direction_.end(), 0.0);
        direction_[j] = 1;
        if (!model.tangent(y, direction_, change_)) {
          return false;
        }
        std::copy(change_.begin(), change_.end(), systems_.column(j).begin());
      }
      return true;
    } else {
      return false;
    }
  }

  void by_differences(M& model, const Task& task, const State& y, const State& rate) {
    direction_ = y;
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double wanted = std::sqrt(std::numeric_limits<double>::epsilon()) * (task.scales.of(j) + std::abs(y[j]));
      direction_[j] = y[j] + wanted;
      const double difference = direction_[j] - y[j];
      model.rates(direction_, change_);
      ++evaluations_;
      for (std::size_t i = 0; i < y.size(); ++i) {
        systems_.column(j)[i] = (change_[i] - rate[i]) / difference;
      }
      direction_[j] = y[j];
    }
  }

  StageSystems systems_;
  State direction_, change_;
  double factored_step_ = 0;  ///< 0: none
  bool is_valid_ = false;     ///< good enough for the next step
  bool is_current_ = false;   ///< taken where that begins
  long taken_ = 0;
  long differenced_ = 0;
  long factorisations_ = 0;
  long evaluations_ = 0;
};

}  // namespace mbrt
