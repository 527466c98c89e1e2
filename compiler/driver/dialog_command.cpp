#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <mbrt/nearest_start.hpp>

#include "dialog/pipe.hpp"
#include "dialog/terminal.hpp"
#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"
#include "driver/interpreted_model.hpp"
#include "driver/process.hpp"

namespace mbcc {

namespace {

namespace fs = std::filesystem;

dialog::Findings examine(const std::string& path, const std::string& text, dialog::Depth depth) {
  const Stage until = depth == dialog::Depth::Language ? Stage::System : Stage::Derivatives;
  Compilation compilation = compile(path, text, {false, until, false});
  return {std::move(compilation.sources), std::move(compilation.diagnostics),
          compilation.system ? compilation.system->integration : model::Integration()};
}

std::vector<dialog::Moved> nearest_start(const std::string& path, const std::string& text) {
  const Compilation compilation = compile(path, text, {false, Stage::Program, true});
  if (!compilation.program) {
    return {};
  }
  const model::System& system = *compilation.system;
  InterpretedModel model(*compilation.program, system, compilation.sources);
  model.prepare();
  const std::vector<double> from = model.initial_state();
  const std::vector<double> to = mbrt::nearest_start(model, system.integration.from.value_or(0));
  std::vector<dialog::Moved> start;
  const std::size_t coordinates = system.coordinates.size();
  for (std::size_t i = 0; i < to.size(); ++i) {
    const std::string& name = i < coordinates ? system.coordinates[i].name : system.speeds[i - coordinates].name;
    start.push_back({name, from[i], to[i]});
  }
  return start;
}

/// In a process of its own, which becomes the simulation: the dialog goes on after it.
int run(const std::vector<std::string>& arguments) {
  std::error_code ignored;
  std::vector<std::string> command = {fs::read_symlink("/proc/self/exe", ignored).string(), "run"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_process(command).exit_code;
}

/// The name of the model whose draft in this directory is the newest.
std::string newest_draft() {
  std::string name;
  fs::file_time_type newest;
  std::error_code failure;
  for (fs::directory_iterator entry(".", failure), end; entry != end && !failure; entry.increment(failure)) {
    const fs::path model = entry->path().stem();  // of NAME.mbd.draft
    if (entry->path().extension() != ".draft" || model.extension() != ".mbd") {
      continue;
    }
    std::error_code gone;
    const fs::file_time_type time = entry->last_write_time(gone);
    if (!gone && (name.empty() || time > newest)) {
      name = model.stem().string();
      newest = time;
    }
  }
  return name;
}

dialog::Workshop workshop() {
  return {
      examine,
      nearest_start,
      [](const std::string& path) {
        std::error_code ignored;
        return fs::exists(path, ignored);
      },
      read_file,
      [](const std::string& path, const std::string& text) { return write_file(path, text); },
      [](const std::string& path) {
        std::error_code ignored;
        fs::remove(path, ignored);
      },
      [](const std::string& model, const std::string& program) {
        return compile_command({model, false, false, false, false}, program, false, "");
      },
      [](const std::string& model) {
        return check_command({model, false, false, false, false});
      },
      [](const std::string& model) { return run({model}); },
      [](const std::string& model, const std::string& figure) {
        return run({model, "--plot", figure});
      },
  };
}

int exit_code(const dialog::Session& session) {
  switch (*session.ending()) {
    case dialog::Ending::Complete:
      return session.exit_code();
    case dialog::Ending::WrongModel:
      return exit_wrong_model;
    case dialog::Ending::WrongUsage:
    case dialog::Ending::Unfinished:
      return exit_wrong_usage;
    case dialog::Ending::Interrupted:
      return exit_interrupted;
  }
  return exit_mbcc_bug;
}

}  // namespace

int dialog_command(const std::string& model, const std::string& output, bool force) {
  const bool interactive = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  const Colours colours = interactive ? Colours::On : Colours::Off;
  const std::string default_name = model.empty() && output.empty() ? newest_draft() : "";
  const dialog::Workshop shop = workshop();
  dialog::Session session({model, output, default_name, force, interactive, colours}, shop);
  if (interactive) {
    dialog::Terminal terminal;
    converse(session, terminal);
  } else {
    dialog::Pipe pipe(std::cin, stdout);
    converse(session, pipe);
  }
  fmt::print(stderr, "{}", session.error());
  return exit_code(session);
}

}  // namespace mbcc
