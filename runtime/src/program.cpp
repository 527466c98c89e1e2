#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "interrupt.hpp"
#include "mbrt/any_model.hpp"
#include "options.hpp"
#include "output_file.hpp"
#include "recorder.hpp"
#include "report.hpp"
#include "run.hpp"
#include "summary.hpp"

namespace mbrt {
namespace {

ExitCode exit_code(Status status) {
  switch (status) {
    case Status::Ok:
      return ExitFine;
    case Status::Failed:
      return ExitFailed;
    case Status::Interrupted:
      return ExitInterrupted;
  }
  return ExitFailed;
}

/// A file that the command line may or may not ask for.
std::optional<OutputFile>& open(std::optional<OutputFile>& file, const std::string& path) {
  if (!path.empty()) {
    file.emplace(path);
  }
  return file;
}

/// Whether there is no error; shows one.
bool is_well(const std::string& error) {
  if (!error.empty()) {
    fmt::print(stderr, "error: {}\n", error);
  }
  return error.empty();
}

/// Whether everything written so far has arrived; says so if not.
bool is_well(const std::optional<OutputFile>& file) { return !file || is_well(file->error()); }

bool are_well(const std::vector<std::unique_ptr<RowFile>>& files) {
  return std::all_of(files.begin(), files.end(), [](const auto& file) { return is_well(file->error()); });
}

void print_message(std::string_view message) {
  if (!message.empty()) {
    fmt::print(stderr, "{}{}", message, message.ends_with('\n') ? "" : "\n");
  }
}

}  // namespace

int run_program(AnyModel& model, int argc, char** argv) {
  const Description& description = model.description();
  const std::variant<Options, ExitCode> line = read_command_line(description, argc, argv);
  if (const ExitCode* const code = std::get_if<ExitCode>(&line)) {
    return *code;
  }
  const Options& options = std::get<Options>(line);
  listen_for_interrupts();
  const std::vector<std::unique_ptr<RowFile>> recordings = open_recordings(description, options);
  std::optional<OutputFile> summary;
  if (!are_well(recordings) || !is_well(open(summary, options.summary))) {
    return ExitUsage;
  }
  std::optional<Recorder> recorder;
  if (!recordings.empty()) {
    recorder.emplace(model, options, recordings);
  }
  Outcome outcome = run(model, options, recorder ? &*recorder : nullptr);
  print_message(outcome.message);
  if (recorder) {
    recorder->finish();
    for (const auto& file : recordings) {
      file->commit();
    }
  }
  if (options.repeat > 0 && outcome.status == Status::Ok) {
    const double fastest = fastest_run(model, options);
    outcome.monitored = interrupted();
    outcome.wall_seconds = outcome.monitored ? outcome.wall_seconds : fastest;
  }
  if (summary) {
    summary->write(summary_json(description, options, outcome));
    summary->commit();
  }
  if (!options.quiet && options.csv != "-" && options.summary != "-") {
    fmt::print("{}", report(description, options, outcome));
  }
  return are_well(recordings) && is_well(summary) ? exit_code(outcome.status) : ExitUsage;
}

}  // namespace mbrt
