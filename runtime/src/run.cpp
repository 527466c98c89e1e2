#include "run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "assemble.hpp"
#include "interrupt.hpp"
#include "methods.hpp"
#include "progress.hpp"
#include "records.hpp"
#include "start.hpp"

namespace mbrt {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

const char* component_name(const Description& model, std::size_t component) {
  const std::size_t coordinates = model.coordinates.size();
  return component < coordinates ? model.coordinates[component] : model.speeds[component - coordinates];
}

/// Shows each accepted state to everyone who wants to see it.
class Watch final : public Observer {
 public:
  Watch(AnyModel& model, const Options& options, const std::vector<Island>& islands, std::vector<double> start,
        Recorder* recorder)
      : model_(model), monitor_(model, islands), recorder_(recorder), time_(options.from), state_(std::move(start)) {
    if (options.progress) {
      progress_.emplace(options.from, options.to, Progress::From::FirstStep);
    } else if (!options.quiet && options.csv != "-" && Progress::has_watcher()) {
      progress_.emplace(options.from, options.to, Progress::From::FirstSecond);
    }
  }

  void arriving() override { monitor_.arriving(); }

  bool accepted(double time, std::span<const double> state, std::span<const double> rate,
                const Interpolant* between) override {
    message_ = monitor_.observe(time, state, rate);
    if (!message_.empty()) {
      return false;
    }
    ++accepted_;
    time_ = time;
    state_.assign(state.begin(), state.end());
    if (recorder_ != nullptr) {
      const Clock::time_point begin = Clock::now();
      recorder_->accepted(time, state, rate, between);
      recording_ += seconds_since(begin);
    }
    if (progress_) {
      progress_->reached(time);
    }
    return !interrupted();
  }

  /// What was seen by the end of an integration to `to` that took `seconds` in all.
  Outcome outcome(const Course& course, const Options& options, double seconds) {
    explain(course, options);
    Outcome outcome;
    outcome.message = message_;
    outcome.status = !message_.empty()                      ? Status::Failed
                     : interrupted() && time_ != options.to ? Status::Interrupted
                                                            : Status::Ok;
    outcome.steps = std::max(0L, accepted_ - 1);
    outcome.rejected = course.rejected;
    outcome.evaluations = course.evaluations;
    outcome.projections = course.projections;
    outcome.fallbacks = course.fallbacks;
    outcome.stiff_from = course.stiff_from;
    outcome.jacobians = course.jacobians;
    outcome.differenced = course.differenced;
    outcome.factorisations = course.factorisations;
    outcome.wall_seconds = seconds - recording_;
    outcome.time = time_;
    outcome.state = state_;
    outcome.findings = monitor_.findings();
    return outcome;
  }

 private:
  /// Failures that come between two accepted states.
  void explain(const Course& course, const Options& options) {
    if (course.ending == Ending::NotFinite) {
      message_ = monitor_.explain_step(course.failed_step);
    }
    if (message_.empty() && (course.ending == Ending::NotFinite || course.ending == Ending::StepTooSmall)) {
      message_ = fmt::format("error: at t = {:.9g} no step is short enough for `{}` to stay within the tolerance {}",
                             course.time, component_name(model_.description(), course.component), options.tolerance);
    }
  }

  AnyModel& model_;
  Monitor monitor_;
  Recorder* const recorder_;
  std::optional<Progress> progress_;
  std::string message_;
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

/// The scales are those of the start, with its rate: the one evaluation that is not counted.
Task task_of(AnyModel& model, const std::vector<Island>& islands, const Options& options,
             const std::vector<double>& start) {
  const Untraced untraced(islands);
  std::vector<double> rate(start.size());
  model.rates(start, rate);
  return {options.from,
          options.to,
          options.step,
          options.tolerance,
          scales_of(start, rate, model.description().coordinates.size()),
          options.project && !islands.empty()};
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
  const Task task = task_of(model, islands, options, state);
  const Clock::time_point begin = Clock::now();
  const Course course = integrate(model, islands, options, task, state, &watch);
  Outcome outcome = watch.outcome(course, options, seconds_since(begin));
  for (const Island& island : islands) {
    outcome.solves.push_back(*island.record);
  }
  return outcome;
}

double fastest_run(AnyModel& model, const Options& options) {
  const std::vector<Island> islands = islands_of(model);
  const std::vector<double> start = begin_run(model, islands, options);
  const Task task = task_of(model, islands, options, start);
  std::vector<double> state(start);
  double fastest = std::numeric_limits<double>::infinity();
  for (long i = 0; i < options.repeat && !interrupted(); ++i) {
    std::copy(start.begin(), start.end(), state.begin());
    const Clock::time_point begin = Clock::now();
    integrate(model, islands, options, task, state, nullptr);
    fastest = std::min(fastest, seconds_since(begin));
  }
  return fastest;
}

}  // namespace mbrt
