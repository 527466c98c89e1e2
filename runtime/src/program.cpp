#include <fmt/format.h>

#include <optional>
#include <variant>

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

/// Whether everything written so far has arrived; says so if not.
bool is_well(const std::optional<OutputFile>& file) {
  if (!file || file->error().empty()) {
    return true;
  }
  fmt::print(stderr, "error: {}\n", file->error());
  return false;
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
  std::optional<OutputFile> csv, summary;
  if (!is_well(open(csv, options.csv)) || !is_well(open(summary, options.summary))) {
    return ExitUsage;
  }
  std::optional<Recorder> recorder;
  if (csv) {
    recorder.emplace(model, *csv, options.from, options.every);
  }
  Outcome outcome = run(model, options, recorder ? &*recorder : nullptr);
  print_message(outcome.message);
  if (recorder) {
    recorder->finish();
    csv->commit();
  }
  if (options.repeat > 0 && outcome.status == Status::Ok) {
    const double fastest = fastest_run(model, options);
    outcome.monitored = interrupted();
    outcome.wall_seconds = outcome.monitored ? outcome.wall_seconds : fastest;
  }
  if (summary) {
    summary->write(summary_json(description, outcome));
    summary->commit();
  }
  if (!options.quiet && options.csv != "-" && options.summary != "-") {
    fmt::print("{}", report(description, options, outcome));
  }
  return is_well(csv) && is_well(summary) ? exit_code(outcome.status) : ExitUsage;
}

}  // namespace mbrt
