#include <fmt/format.h>

#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"
#include "driver/model_input.hpp"

namespace mbcc {

namespace {

/// `path` as make reads it.
std::string for_make(const std::string& path) {
  std::string escaped;
  for (const char c : path) {
    escaped += c == ' ' || c == '#' ? "\\" : c == '$' ? "$" : "";
    escaped += c;
  }
  return escaped;
}

std::string dependencies(const Compilation& compilation, const std::string& output) {
  std::string rule = for_make(output) + ":";
  for (std::uint32_t file = 0; file < compilation.sources.size(); ++file) {
    rule += " " + for_make(compilation.sources[file].name());
  }
  return rule + "\n";
}

}  // namespace

int compile_command(const ModelArguments& arguments, const std::string& output, bool library,
                    const std::string& depfile) {
  const std::optional<Compilation> compilation = compile_model(arguments, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (!compilation->succeeded(arguments.werror)) {
    return exit_wrong_model;
  }
  const std::string text = emit(*compilation->program, *compilation->system, compilation->sources,
                                {library, arguments.strict, arguments.method});
  if (!write_file(output, text)) {
    return refuse(fmt::format("cannot write `{}`", output));
  }
  if (!depfile.empty() && !write_file(depfile, dependencies(*compilation, output))) {
    return refuse(fmt::format("cannot write `{}`", depfile));
  }
  return exit_fine;
}

}  // namespace mbcc
