#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
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

/// The recording that a figure is drawn from: the user's, or one that does not stay.
class Recording {
 public:
  Recording(const std::string& figure, const std::vector<std::string>& flags) : temporary_(figure, "csv") {
    constexpr std::string_view flag = "--csv";
    for (std::size_t i = 0; i < flags.size(); ++i) {
      if (flags[i] == flag && i + 1 < flags.size()) {
        path_ = flags[i + 1];
      } else if (flags[i].starts_with(flag) && flags[i].size() > flag.size() && flags[i][flag.size()] == '=') {
        path_ = flags[i].substr(flag.size() + 1);
      }
    }
  }

  const std::string& path() const { return path_.empty() ? temporary_.path() : path_; }

  /// The flags that the simulation needs besides the user's.
  std::vector<std::string> flags() const {
    return path_.empty() ? std::vector<std::string>{"--residuals", "--csv", temporary_.path()}
                         : std::vector<std::string>{"--residuals"};
  }

 private:
  TemporaryFile temporary_;
  std::string path_;
};

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
  const std::string text = emit(*compilation.program, system, compilation.sources, {false, arguments.strict});
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

/// Whether there is anything to draw, be it only the part until the simulation failed.
bool has_rows(const std::string& recording) {
  const std::optional<std::string> text = read_file(recording);
  return text && std::count(text->begin(), text->end(), '\n') > 1;
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
  if (plot.empty()) {
    return simulate(*compilation, arguments, cxx_flags, flags, false);
  }
  const Recording recording(plot, flags);
  std::vector<std::string> all_flags = flags;
  for (const std::string& flag : recording.flags()) {
    all_flags.push_back(flag);
  }
  const int code = simulate(*compilation, arguments, cxx_flags, all_flags, true);
  if (!has_rows(recording.path())) {
    return code;
  }
  const int drawn = draw_figure({recording.path()}, subject_of_run(*compilation, arguments.model, flags), plot);
  return code == exit_fine ? drawn : code;
}

}  // namespace mbcc
