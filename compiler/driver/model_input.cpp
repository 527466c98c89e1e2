#include "driver/model_input.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "diagnostics/render.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"

namespace mbcc {

namespace {

void show(const Compilation& compilation, const ModelArguments& arguments) {
  if (arguments.json_diagnostics) {
    fmt::print(stderr, "{}\n", render_json(compilation.diagnostics, compilation.sources));
    return;
  }
  const Colours colours = isatty(STDERR_FILENO) != 0 ? Colours::On : Colours::Off;
  fmt::print(stderr, "{}", render(compilation.diagnostics, compilation.sources, colours));
  if (arguments.werror && !compilation.diagnostics.has_errors() && compilation.diagnostics.warnings() != 0) {
    fmt::print(stderr, "mbcc: error: warnings count as errors here (`--werror`)\n");
  }
}

}  // namespace

int refuse(const std::string& message) {
  fmt::print(stderr, "mbcc: error: {}\n", message);
  return exit_wrong_usage;
}

std::optional<Compilation> compile_model(const ModelArguments& arguments, Stage until) {
  std::optional<std::string> text = read_file(arguments.model);
  if (!text) {
    refuse(fmt::format("cannot read `{}`", arguments.model));
    return std::nullopt;
  }
  const std::string name = arguments.model == "-" ? "model.mbd" : arguments.model;
  Compilation compilation =
      compile(name, std::move(*text), {arguments.strict, until, arguments.assembles, arguments.method});
  show(compilation, arguments);
  return compilation;
}

}  // namespace mbcc
