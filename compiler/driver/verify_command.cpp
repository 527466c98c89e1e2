#include <fmt/format.h>

#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"
#include "driver/model_input.hpp"
#include "driver/process.hpp"

namespace mbcc {

namespace {

/// A unified diff, by the system's `diff`.
void print_difference(const std::string& old_text, const std::string& old_name, const std::string& new_text,
                      const std::string& new_name) {
  const ScratchFile old_file(old_text);
  const ScratchFile new_file(new_text);
  constexpr int files_differ = 1;
  if (run_process({"diff", "-u", "-L", old_name, "-L", new_name, old_file.path(), new_file.path()}).exit_code !=
      files_differ) {
    fmt::print(stderr, "mbcc: error: `{}` is not {}, and `diff` could not show where\n", old_name, new_name);
  }
}

}  // namespace

int verify_command(const ModelArguments& arguments, const std::string& emitted) {
  const std::optional<std::string> old_text = read_file(emitted);
  if (!old_text) {
    return refuse(fmt::format("cannot read `{}`", emitted));
  }
  const std::optional<EmitOptions> options = options_of(*old_text);
  if (!options) {
    fmt::print(stderr, "mbcc: error: `{}` is no file that mbcc emitted: its header names no options\n", emitted);
    return exit_wrong_model;
  }
  ModelArguments as_emitted = arguments;
  as_emitted.strict |= options->strict;
  as_emitted.method = options->method;
  const std::optional<Compilation> compilation = compile_model(as_emitted, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (!compilation->succeeded(arguments.werror)) {
    return exit_wrong_model;
  }
  const std::string text = emit(*compilation->program, *compilation->system, compilation->sources, *options);
  if (text == *old_text) {
    return exit_fine;
  }
  print_difference(*old_text, emitted, text, fmt::format("what mbcc {} emits for {}", version, arguments.model));
  return exit_wrong_model;
}

}  // namespace mbcc
