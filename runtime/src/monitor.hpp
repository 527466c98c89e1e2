#pragma once
// What a run is watched for at every accepted state.

#include <span>
#include <string>
#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// Largest absolute errors of one constraint; NaN once one was.
struct LargestErrors {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// At `time` the rank of an island became `rank`.
struct RankEvent {
  double time;
  std::size_t island;
  int rank;
};

struct Findings {
  std::vector<LargestErrors> constraints;
  double initial_energy = 0;
  double final_energy = 0;
  double energy_drift = 0;             ///< largest |E - initial E|
  int smallest_rank = 0;               ///< of all constraints together, at accepted states
  std::vector<RankEvent> rank_events;  ///< the first `most_rank_events`
  long rank_changes = 0;               ///< all of them
};

inline constexpr std::size_t most_rank_events = 100;

class Monitor {
 public:
  Monitor(AnyModel& model, const std::vector<Island>& islands);

  /// Before the rate at an accepted state is evaluated.
  void arriving();

  /// After it. Returns why the run cannot go on, or nothing.
  std::string observe(double time, std::span<const double> state, std::span<const double> rate);

  /// Why the rates are not finite of a step from the last accepted state; nothing where none is found.
  std::string explain_step(double step);

  const Findings& findings() const { return findings_; }

 private:
  std::string explain_failure(double time, std::span<const double> state);
  void watch_constraints(std::span<const double> state, std::span<const double> rate);
  void watch_energy(std::span<const double> state);
  std::string watch_rank(double time, std::span<const double> state, std::span<const double> rate);

  AnyModel& model_;
  const std::vector<Island>& islands_;
  Findings findings_;
  std::vector<int> ranks_;  // of the islands at the last accepted state
  std::vector<double> position_, velocity_, acceleration_;
  std::vector<double> last_state_;
  double last_time_ = 0;
  bool started_ = false;
};

}  // namespace mbrt
