#include "assemble.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint_distance.hpp"
#include "records.hpp"

namespace mbrt {
namespace {

constexpr int most_rounds = 100;  // Newton's method needs ten at most, unless there is nothing to reach
constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();

double largest(std::span<const double> values) {
  double size = 0;
  for (const double value : values) {
    size = std::max(size, std::abs(value));
  }
  return size;
}

/// Moves the coordinates, or the speeds, of a state onto the constraints.
class Assembly {
 public:
  enum class Level { Position, Velocity };

  Assembly(AnyModel& model, const std::vector<Island>& islands, const std::vector<bool>& held,
           std::vector<double>& state, Level level)
      : model_(model),
        description_(model.description()),
        islands_(islands),
        level_(level),
        state_(state),
        first_(level == Level::Position ? 0 : description_.coordinates.size()),
        moving_(std::span(state).subspan(first_, description_.speeds.size())),
        held_(held),
        no_rate_(state.size()),
        position_(description_.constraints.size()),
        velocity_(position_),
        acceleration_(position_),
        moved_(moving_.size()),
        step_(moving_.size()) {}

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
      find_step([](std::span<const double>, std::size_t) { return 0.0; });
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
      measure();
      find_step([this](std::span<const double> row, std::size_t island) { return along(row, island); });
      for (std::size_t j = 0; j < step_.size(); ++j) {
        step_[j] -= moved_[j];
      }
      const double size = largest(step_);
      if (!(size < 0.9 * last) || size <= rounding * extent(moving_)) {
        return;
      }
      move(1);
      last = size;
    }
  }

  /// How far the displacement so far goes along one row of an island.
  double along(std::span<const double> row, std::size_t island) const {
    double sum = 0;
    const std::span<const int> speeds = description_.islands[island].speeds;
    for (std::size_t j = 0; j < row.size(); ++j) {
      sum += row[j] * moved_[static_cast<std::size_t>(speeds[j])];
    }
    return sum;
  }

  void move(double factor) {
    for (std::size_t j = 0; j < step_.size(); ++j) {
      moving_[j] += factor * step_[j];
      moved_[j] += factor * step_[j];
    }
  }

  std::span<const double> errors() const { return level_ == Level::Position ? position_ : velocity_; }

  /// Whether a row counts: a constraint on speeds does not bind coordinates.
  bool binds(std::size_t constraint) const {
    return level_ == Level::Velocity || description_.constraints[constraint].holonomic;
  }

  /// The size of all errors in units of the scaled rows; infinite where one is no number.
  double measure() {
    model_.constraint_errors(state_, no_rate_, position_, velocity_, acceleration_);
    double sum = 0;
    for (std::size_t k = 0; k < islands_.size(); ++k) {
      for (std::size_t row = 0; row < islands_[k].scale.size(); ++row) {
        const auto constraint = static_cast<std::size_t>(description_.islands[k].constraints[row]);
        const double error = binds(constraint) ? islands_[k].scale[row] * errors()[constraint] : 0;
        sum += error * error;
      }
    }
    return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
  }

  /// The shortest step that makes A step = `wanted(row) - error` on every row, as far as A can.
  template <class Wanted>
  void find_step(const Wanted& wanted) {
    for (std::size_t k = 0; k < islands_.size(); ++k) {
      const Island& island = islands_[k];
      const IslandRows& rows = island.rows;
      const std::size_t columns = rows.mobility.size();
      model_.island_rows(static_cast<int>(k), state_);
      double distance_off = 0;
      for (std::size_t i = 0; i < rows.residual.size(); ++i) {
        const auto constraint = static_cast<std::size_t>(description_.islands[k].constraints[i]);
        const std::span<double> row = rows.matrix.subspan(i * columns, columns);
        if (binds(constraint)) {
          rows.residual[i] = wanted(row, k) - errors()[constraint];
          distance_off = std::max(distance_off, distance(errors()[constraint], row_norm(rows, i)));
        } else {
          rows.residual[i] = 0;
          std::fill(row.begin(), row.end(), 0.0);
        }
      }
      solve(island, description_.islands[k].speeds, distance_off / extent(moving_));
    }
  }

  void solve(const Island& island, std::span<const int> speeds, double relative_distance) {
    for (std::size_t j = 0; j < speeds.size(); ++j) {
      if (held_[first_ + static_cast<std::size_t>(speeds[j])]) {
        island.rows.mobility[j] = 0;
      }
    }
    const double cutoff = island.record->cutoff;
    island.record->cutoff = std::clamp(relative_distance, cutoff, std::max(cutoff, largest_cutoff));
    added_.resize(speeds.size());
    climb(island, added_);
    island.record->cutoff = cutoff;
    for (std::size_t j = 0; j < speeds.size(); ++j) {
      step_[static_cast<std::size_t>(speeds[j])] = added_[j];
    }
  }

  AnyModel& model_;
  const Description& description_;
  const std::vector<Island>& islands_;
  const Level level_;
  const std::vector<double>& state_;
  const std::size_t first_;         // element of the state that moves first
  const std::span<double> moving_;  // coordinates or speeds
  const std::vector<bool>& held_;
  const std::vector<double> no_rate_;
  std::vector<double> position_, velocity_, acceleration_;  // errors at the state
  std::vector<double> moved_, step_;                        // since the beginning, and next; per speed
  std::vector<double> added_;                               // of one island
};

}  // namespace

void assemble(AnyModel& model, const std::vector<Island>& islands, const std::vector<bool>& held,
              std::vector<double>& state) {
  const Untraced untraced(islands);
  for (const Assembly::Level level : {Assembly::Level::Position, Assembly::Level::Velocity}) {
    Assembly(model, islands, held, state, level).assemble();
  }
}

}  // namespace mbrt
