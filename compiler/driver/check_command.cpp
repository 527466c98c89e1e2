#include <fmt/format.h>

#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/model_input.hpp"
#include "driver/structure.hpp"

namespace mbcc {

int check_command(const ModelArguments& arguments) {
  const std::optional<Compilation> compilation = compile_model(arguments, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (compilation->program) {
    fmt::print("{}", print_structure(*compilation));
  }
  return compilation->succeeded(arguments.werror) ? exit_fine : exit_wrong_model;
}

}  // namespace mbcc
