#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <mbrt/dop853.hpp>
#include <mbrt/simulation.hpp>

#include "driver/build.hpp"
#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/figures.hpp"
#include "driver/files.hpp"
#include "driver/interpreted_model.hpp"
#include "driver/model_input.hpp"
#include "driver/process.hpp"

namespace mbcc {

namespace {

/// An argument vector as main gets it; `words` must outlive it.
std::vector<char*> as_argv(std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  return argv;
}

/// The file of `--csv` among the flags of a simulation; empty if there is none.
std::string recording_in(const std::vector<std::string>& flags) {
  constexpr std::string_view flag = "--csv", with_value = "--csv=";
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (flags[i] == flag && i + 1 < flags.size()) {
      return flags[i + 1];
    }
    if (flags[i].starts_with(with_value)) {
      return flags[i].substr(with_value.size());
    }
  }
  return {};
}

/// Whether what is written there can be read again.
bool stays(const std::string& path) {
  std::error_code ignored;
  return path != "-" && (!std::filesystem::exists(path, ignored) || std::filesystem::is_regular_file(path, ignored));
}

/// Runs the simulation, in place of mbcc unless `returns`; the exit code.
int simulate(const Compilation& compilation, const ModelArguments& arguments, const std::string& cxx_flags,
             const std::vector<std::string>& flags, bool returns) {
  const model::System& system = *compilation.system;
  std::vector<std::string> words{system.name};
  words.insert(words.end(), flags.begin(), flags.end());
  std::vector<char*> argv = as_argv(words);

  const auto compiler = find_cxx_compiler();
  if (!compiler) {
    fmt::print(stderr, "mbcc: note: no C++ compiler found (`CXX`, `c++`): the interpreter runs the model\n");
    InterpretedModel model(*compilation.program, system, compilation.sources);
    return mbrt::simulate<mbrt::Dop853>(model, static_cast<int>(words.size()), argv.data());
  }
  const std::string text =
      emit(*compilation.program, system, compilation.sources, {false, arguments.strict, arguments.method});
  const BuildResult built = build_program(text, *compiler, split_words(cxx_flags));
  if (built.interrupted) {
    return exit_interrupted;
  }
  if (built.program.empty()) {
    fmt::print(stderr, "{}mbcc: error: the emitted program did not build\n", built.output);
    return exit_mbcc_bug;
  }
  if (returns) {
    words.front() = built.program;
    return run_process(words).exit_code;
  }
  execv(built.program.c_str(), argv.data());
  return refuse(fmt::format("cannot execute `{}`", built.program));
}

bool has_rows(const std::string& recording) {
  std::ifstream file(recording);
  std::string line;
  return std::getline(file, line) && std::getline(file, line);
}

/// Runs the simulation and draws what it has recorded, be it only the part until it failed: the user's own recording,
/// or one that does not stay.
int simulate_and_draw(const Compilation& compilation, const ModelArguments& arguments, const std::string& cxx_flags,
                      std::vector<std::string> flags, const std::string& figure) {
  const TemporaryFile temporary(figure, "csv");
  std::string recording = recording_in(flags);
  if (!stays(recording)) {
    return refuse(fmt::format("`--plot` draws what `--csv` records, and `{}` is no file", recording));
  }
  if (recording.empty()) {
    recording = temporary.path();
    flags.insert(flags.end(), {"--csv", recording});
  }
  flags.emplace_back("--residuals");
  const int code = simulate(compilation, arguments, cxx_flags, flags, true);
  if (!has_rows(recording)) {
    return code;
  }
  const int drawn = draw_figure({recording}, subject_of_run(compilation, arguments.model, flags), figure);
  return code == exit_fine ? drawn : code;
}

}  // namespace

int run_command(const ModelArguments& arguments, const std::string& cxx_flags, const std::vector<std::string>& flags,
                const std::string& plot) {
  if (const std::string obstacle = plot.empty() ? "" : obstacle_to_figure(plot); !obstacle.empty()) {
    return refuse(obstacle);
  }
  const std::optional<Compilation> compilation = compile_model(arguments, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (!compilation->succeeded(arguments.werror)) {
    return exit_wrong_model;
  }
  return plot.empty() ? simulate(*compilation, arguments, cxx_flags, flags, false)
                      : simulate_and_draw(*compilation, arguments, cxx_flags, flags, plot);
}

}  // namespace mbcc
