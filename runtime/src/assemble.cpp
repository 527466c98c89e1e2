#include "assemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint_distance.hpp"
#include "correction.hpp"

namespace mbrt {
namespace {

constexpr int most_rounds = 100;  // Newton's method needs ten at most, unless there is nothing to reach
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

/// Moves the coordinates, or the speeds, of a state onto the constraints.
class Assembly {
 public:
  /// `held` marks coordinates or speeds, as `terms` says.
  Assembly(Correction& correction, const ErrorTerms& terms, std::vector<double>& state, std::span<double> moving,
           std::size_t speeds, std::vector<bool> held)
      : correction_(correction),
        terms_(terms),
        state_(state),
        moving_(moving),
        held_(std::move(held)),
        moved_(speeds),
        step_(speeds) {}

  void assemble() {
    reach();
    approach_the_nearest();
    reach();
  }

 private:
  /// Gauss-Newton, for as long as the errors decrease.
  void reach() {
    double error = measure();
    for (int round = 0; round < most_rounds && error > 0; ++round) {
      find_step({});
      const double before = error;
      error = advance(before);
      if (!(error < before)) {
        return;
      }
    }
  }

  /// Moves by the step, or by that half of a half of it which makes the errors smaller; their new size.
  double advance(double before) {
    constexpr int most_halvings = 20;
    double factor = 1;
    for (int halving = 0; halving < most_halvings; ++halving, factor /= 2) {
      move(factor);
      if (const double error = measure(); error < before) {
        return error;
      }
      move(-factor);
    }
    return before;
  }

  /// The iteration of Note [nearest start], for as long as it contracts.
  void approach_the_nearest() {
    double last = std::numeric_limits<double>::infinity();
    for (int round = 0; round < most_rounds; ++round) {
      find_step(moved_);
      double size = 0;
      for (std::size_t j = 0; j < step_.size(); ++j) {
        step_[j] -= moved_[j];
        size = std::max(size, std::abs(step_[j]));
      }
      if (!(size < 0.9 * last) || size <= rounding * extent(moving_)) {
        return;
      }
      move(1);
      last = size;
    }
  }

  double measure() { return correction_.size(terms_, state_); }

  void find_step(std::span<const double> moved) {
    const std::span<const double> step = correction_.step(terms_, state_, moved, held_);
    step_.assign(step.begin(), step.end());
  }

  void move(double factor) {
    const std::span<const double> change =
        terms_.velocity == 0 ? correction_.coordinates_of(state_, step_) : std::span<const double>(step_);
    for (std::size_t i = 0; i < moving_.size(); ++i) {
      moving_[i] += factor * change[i];
    }
    for (std::size_t j = 0; j < step_.size(); ++j) {
      moved_[j] += factor * step_[j];
    }
  }

  Correction& correction_;
  const ErrorTerms terms_;
  const std::vector<double>& state_;
  const std::span<double> moving_;  // coordinates or speeds of the state
  const std::vector<bool> held_;
  std::vector<double> moved_, step_;  // along the speeds: since the beginning, and next
};

}  // namespace

void assemble(AnyModel& model, const std::vector<Island>& islands, const std::vector<bool>& held,
              std::vector<double>& state) {
  Correction correction(model, islands);
  const std::size_t coordinates = model.description().coordinates.size();
  const auto first_speed = static_cast<std::ptrdiff_t>(coordinates);
  const std::span<double> all = state;
  const std::size_t speeds = model.description().speeds.size();
  Assembly(correction, errors_of_position, state, all.first(coordinates), speeds,
           {held.begin(), held.begin() + first_speed})
      .assemble();
  Assembly(correction, errors_of_velocity, state, all.subspan(coordinates), speeds,
           {held.begin() + first_speed, held.end()})
      .assemble();
}

}  // namespace mbrt
