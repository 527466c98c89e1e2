#include "monitor.hpp"

#include <algorithm>
#include <cmath>

#include "failures.hpp"
#include "mbrt/math.hpp"
#include "methods.hpp"
#include "records.hpp"

namespace mbrt {

Monitor::Monitor(AnyModel& model, const std::vector<Island>& islands) : model_(model), islands_(islands) {
  const std::size_t constraints = model.description().constraints.size();
  findings_.constraints.resize(constraints);
  position_.resize(constraints);
  velocity_.resize(constraints);
  acceleration_.resize(constraints);
  last_state_.resize(state_size(model.description()));
  for (const Island& island : islands_) {
    ranks_.push_back(static_cast<int>(island.scale.size()));
    findings_.smallest_rank += ranks_.back();
  }
}

void Monitor::arriving() {
  for (const Island& island : islands_) {
    island.record->rank = static_cast<int>(island.scale.size());
  }
}

std::string Monitor::observe(double time, std::span<const double> state, std::span<const double> rate) {
  if (!all_finite(state) || !all_finite(rate)) {
    return explain_failure(time, state);
  }
  watch_constraints(state, rate);
  if (model_.description().has_energy) {
    watch_energy(state);
  }
  std::copy(state.begin(), state.end(), last_state_.begin());
  last_time_ = time;
  started_ = true;
  return watch_rank(time, state, rate);
}

std::string Monitor::explain_failure(double time, std::span<const double> state) {
  if (all_finite(state) || !started_) {
    const Untraced untraced(islands_);
    return explain_not_finite(model_, islands_, time, state);
  }
  std::string cause = explain_step(time - last_time_);
  return cause.empty() ? explain_not_finite(model_, islands_, last_time_, last_state_) : cause;
}

/// A stage that is not finite spoils the whole state after its step: the cause shows at the stage alone. Longer steps
/// are tried where the methods' stages differ.
std::string Monitor::explain_step(double step) {
  constexpr int most_steps = 16;
  constexpr double longer = 8;
  const Untraced untraced(islands_);
  double stage_time = not_given;
  for (int i = 0; i < most_steps && std::isnan(stage_time); ++i, step *= longer) {
    stage_time = find_failing_stage(model_, last_time_, step, last_state_);
  }
  return std::isnan(stage_time) ? "" : explain_not_finite(model_, islands_, stage_time, last_state_);
}

void Monitor::watch_constraints(std::span<const double> state, std::span<const double> rate) {
  if (findings_.constraints.empty()) {
    return;
  }
  model_.constraint_errors(state, rate, position_, velocity_, acceleration_);
  for (std::size_t i = 0; i < position_.size(); ++i) {
    LargestErrors& largest = findings_.constraints[i];
    largest.position = max(largest.position, std::abs(position_[i]));
    largest.velocity = max(largest.velocity, std::abs(velocity_[i]));
    largest.acceleration = max(largest.acceleration, std::abs(acceleration_[i]));
  }
}

void Monitor::watch_energy(std::span<const double> state) {
  findings_.final_energy = model_.energy(state);
  if (!started_) {
    findings_.initial_energy = findings_.final_energy;
  }
  findings_.energy_drift = max(findings_.energy_drift, std::abs(findings_.final_energy - findings_.initial_energy));
}

std::string Monitor::watch_rank(double time, std::span<const double> state, std::span<const double> rate) {
  int together = 0;
  for (const Island& island : islands_) {
    together += island.record->rank;
  }
  findings_.smallest_rank = std::min(findings_.smallest_rank, together);
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    const int rank = islands_[k].record->rank;
    if (rank != ranks_[k]) {
      ranks_[k] = rank;
      ++findings_.rank_changes;
      if (findings_.rank_events.size() < most_rank_events) {
        findings_.rank_events.push_back({time, k, rank});
      }
    }
    if (rank < static_cast<int>(islands_[k].scale.size())) {
      const Untraced untraced(islands_);
      std::string contradiction =
          find_contradiction(model_, islands_[k], static_cast<int>(k), time, state, rate, acceleration_);
      if (!contradiction.empty()) {
        return contradiction;
      }
    }
  }
  return {};
}

}  // namespace mbrt
