#include <fmt/format.h>
#include <unistd.h>

#include <mbrt/dop853.hpp>
#include <mbrt/simulation.hpp>

#include "driver/build.hpp"
#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/interpreted_model.hpp"
#include "driver/model_input.hpp"

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

}  // namespace

int run_command(const ModelArguments& arguments, const std::string& cxx_flags, const std::vector<std::string>& flags) {
  const std::optional<Compilation> compilation = compile_model(arguments, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (!compilation->succeeded(arguments.werror)) {
    return exit_wrong_model;
  }
  const model::System& system = *compilation->system;
  std::vector<std::string> words{system.name};
  words.insert(words.end(), flags.begin(), flags.end());
  std::vector<char*> argv = as_argv(words);

  const auto compiler = find_cxx_compiler();
  if (!compiler) {
    fmt::print(stderr, "mbcc: note: no C++ compiler found (`CXX`, `c++`): the interpreter runs the model\n");
    InterpretedModel model(*compilation->program, system, compilation->sources);
    return mbrt::simulate<mbrt::Dop853>(model, static_cast<int>(words.size()), argv.data());
  }
  const std::string text = emit(*compilation->program, system, compilation->sources, {false, arguments.strict});
  const BuildResult built = build_program(text, *compiler, split_words(cxx_flags));
  if (built.interrupted) {
    return exit_interrupted;
  }
  if (built.program.empty()) {
    fmt::print(stderr, "{}mbcc: error: the emitted program did not build\n", built.output);
    return exit_mbcc_bug;
  }
  execv(built.program.c_str(), argv.data());
  return refuse(fmt::format("cannot execute `{}`", built.program));
}

}  // namespace mbcc
