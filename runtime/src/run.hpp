#pragma once
// One run of a model: what is asked of it, and all that it leaves behind.

#include <optional>
#include <string>
#include <vector>

#include "mbrt/any_model.hpp"
#include "monitor.hpp"
#include "options.hpp"
#include "recorder.hpp"

namespace mbrt {

enum class Status { Ok, Failed, Interrupted };

/// As summaries say it.
const char* name(Status status);

struct Outcome {
  Status status = Status::Ok;
  std::string message;  ///< why it failed, as shown to the user
  long steps = 0;       ///< accepted
  long rejected = 0;
  long evaluations = 0;
  long fallbacks = 0;             ///< steps of `taylor` that were taken by dop853
  double stiff_from = not_given;  ///< when stability came to bound the steps of `dop853`
  long jacobians = 0;             ///< that `radau` took
  long differenced = 0;           ///< of those, by differences
  long factorisations = 0;
  long projections = 0;
  double wall_seconds = 0;
  bool monitored = true;  ///< whether wall_seconds includes the monitors
  double time = 0;        ///< of the last accepted state
  std::vector<double> state;
  Findings findings;
  std::vector<IslandRecord> solves;  ///< per island
};

/// Integrates with monitors; `recorder` may be null.
Outcome run(AnyModel& model, const Options& options, Recorder* recorder);

/// Integrates options.repeat times from the same start and nothing else; the seconds of the fastest.
double fastest_run(AnyModel& model, const Options& options);

}  // namespace mbrt
