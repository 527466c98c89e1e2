#include "run.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "assemble.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "records.hpp"
#include "start.hpp"

namespace mbrt {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Shows each accepted state to everyone who wants to see it.
class Watch final : public Observer {
 public:
  Watch(AnyModel& model, const Options& options, const std::vector<Island>& islands, std::vector<double> start,
        Recorder* recorder)
      : monitor_(model, islands), recorder_(recorder), time_(options.from), state_(std::move(start)) {
    if (options.progress) {
      progress_.emplace(options.from, options.to, Progress::From::FirstStep);
    } else if (!options.quiet && options.csv != "-" && Progress::has_watcher()) {
      progress_.emplace(options.from, options.to, Progress::From::FirstSecond);
    }
  }

  void arriving() override { monitor_.arriving(); }

  bool accepted(double time, std::span<const double> state, std::span<const double> rate) override {
    ++arrivals_;
    message_ = monitor_.observe(time, state, rate);
    if (!message_.empty()) {
      return false;
    }
    ++accepted_;
    time_ = time;
    state_.assign(state.begin(), state.end());
    if (recorder_ != nullptr) {
      const Clock::time_point begin = Clock::now();
      recorder_->accepted(time, state, rate);
      recording_ += seconds_since(begin);
    }
    if (progress_) {
      progress_->reached(time);
    }
    return !interrupted();
  }

  /// What was seen by the end of an integration to `to` that took `seconds` in all.
  Outcome outcome(double to, double seconds) const {
    Outcome outcome;
    outcome.message = message_;
    outcome.status = !message_.empty()              ? Status::Failed
                     : interrupted() && time_ != to ? Status::Interrupted
                                                    : Status::Ok;
    outcome.steps = std::max(0L, accepted_ - 1);
    outcome.evaluations = 4 * (arrivals_ - 1) + 1;
    outcome.wall_seconds = seconds - recording_;
    outcome.time = time_;
    outcome.state = state_;
    outcome.findings = monitor_.findings();
    return outcome;
  }

 private:
  Monitor monitor_;
  Recorder* const recorder_;
  std::optional<Progress> progress_;
  std::string message_;
  long arrivals_ = 0;
  long accepted_ = 0;
  double recording_ = 0;
  double time_;  // of the last accepted state
  std::vector<double> state_;
};

/// Sets the model's time to the start, and the islands to the start's scales; the start is assembled if it is to be.
std::vector<double> begin_run(AnyModel& model, const std::vector<Island>& islands, const Options& options) {
  std::vector<double> state = start_state(model, options);
  for (const Island& island : islands) {
    island.record->cutoff = options.cutoff;
  }
  take_row_scales(model, islands, options.from, state);
  if (options.assemble) {
    assemble(model, islands, held_elements(options, state.size()), state);
    take_row_scales(model, islands, options.from, state);
  }
  return state;
}

Outcome inconsistent_start(const Options& options, std::string message, std::vector<double> state) {
  Outcome outcome;
  outcome.status = Status::Failed;
  outcome.message = std::move(message);
  outcome.time = options.from;
  outcome.state = std::move(state);
  return outcome;
}

}  // namespace

const char* name(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::Failed:
      return "failed";
    case Status::Interrupted:
      return "interrupted";
  }
  return "";
}

Outcome run(AnyModel& model, const Options& options, Recorder* recorder) {
  const std::vector<Island> islands = islands_of(model);
  std::vector<double> state = begin_run(model, islands, options);
  if (std::string message = find_inconsistencies(model, islands, state); !message.empty()) {
    return inconsistent_start(options, std::move(message), std::move(state));
  }
  Watch watch(model, options, islands, state, recorder);
  const Clock::time_point begin = Clock::now();
  model.integrate(time_grid(options.from, options.to, options.step), state, watch);
  Outcome outcome = watch.outcome(options.to, seconds_since(begin));
  for (const Island& island : islands) {
    outcome.solves.push_back(*island.record);
  }
  return outcome;
}

double fastest_run(AnyModel& model, const Options& options) {
  const TimeGrid grid = time_grid(options.from, options.to, options.step);
  const std::vector<Island> islands = islands_of(model);
  const std::vector<double> start = begin_run(model, islands, options);
  std::vector<double> state(start);
  double fastest = std::numeric_limits<double>::infinity();
  for (long i = 0; i < options.repeat && !interrupted(); ++i) {
    std::copy(start.begin(), start.end(), state.begin());
    const Clock::time_point begin = Clock::now();
    model.integrate(grid, state);
    fastest = std::min(fastest, seconds_since(begin));
  }
  return fastest;
}

}  // namespace mbrt
