#include <fmt/format.h>

#include <array>
#include <string_view>

#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/model_input.hpp"
#include "mechanics/print.hpp"
#include "model/resolve.hpp"
#include "program/schedule.hpp"
#include "syntax/parser.hpp"

namespace mbcc {

namespace {

struct NamedStage {
  std::string_view name;
  Stage stage;
};
constexpr std::array stages = {NamedStage{"tokens", Stage::Tokens},           NamedStage{"syntax", Stage::Syntax},
                               NamedStage{"system", Stage::System},           NamedStage{"equations", Stage::Equations},
                               NamedStage{"derivatives", Stage::Derivatives}, NamedStage{"program", Stage::Program}};

std::string print_stage(const Compilation& compilation, Stage stage, bool partials) {
  switch (stage) {
    case Stage::Tokens:
      return print(compilation.tokens, compilation.sources);
    case Stage::Syntax:
      return print(compilation.tree);
    case Stage::System:
      return print(*compilation.system);
    case Stage::Equations:
      return print(compilation.equations, *compilation.system);
    case Stage::Derivatives:
      return partials ? mechanics::print_partials(*compilation.system, compilation.equations)
                      : print(compilation.derivatives, *compilation.system);
    case Stage::Program:
      return print(*compilation.program, *compilation.system);
  }
  return {};
}

}  // namespace

int dump_command(const ModelArguments& arguments, const std::string& stage, bool partials) {
  const auto* const found =
      std::find_if(stages.begin(), stages.end(), [&](const NamedStage& candidate) { return candidate.name == stage; });
  if (found == stages.end()) {
    return refuse(
        fmt::format("there is no stage `{}`: tokens, syntax, system, equations, derivatives, program", stage));
  }
  if (partials && found->stage != Stage::Derivatives) {
    return refuse("`--partials` goes with `--stage=derivatives`");
  }
  const std::optional<Compilation> compilation = compile_model(arguments, found->stage);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (compilation->diagnostics.has_errors() && found->stage > Stage::Syntax) {
    return exit_wrong_model;
  }
  fmt::print("{}", print_stage(*compilation, found->stage, partials));
  return compilation->succeeded(arguments.werror) ? exit_fine : exit_wrong_model;
}

}  // namespace mbcc
