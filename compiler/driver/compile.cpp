#include "driver/compile.hpp"

#include <utility>

#include "driver/files.hpp"
#include "model/methods.hpp"
#include "model/resolve.hpp"
#include "program/schedule.hpp"
#include "syntax/parser.hpp"

namespace mbcc {

namespace {

/// Reads, lexes and parses what an `import` names.
std::optional<ImportedFile> import_file(Compilation& compilation, const std::string& path, std::uint32_t importing) {
  const std::string resolved = relative_to_file(compilation.sources[importing].name(), path);
  std::optional<std::string> text = read_file(resolved);
  if (!text) {
    return std::nullopt;
  }
  const std::uint32_t file = compilation.sources.add(resolved, std::move(*text));
  return ImportedFile{file, parse(lex(compilation.sources, file, compilation.diagnostics), compilation.diagnostics)};
}

}  // namespace

Compilation compile(std::string name, std::string text, const CompileOptions& options) {
  Compilation c;
  const std::uint32_t file = c.sources.add(std::move(name), std::move(text));
  const Importer importer = [&c](const std::string& path, std::uint32_t from) { return import_file(c, path, from); };

  c.tokens = lex(c.sources, file, c.diagnostics);
  if (options.until == Stage::Tokens) {
    return c;
  }
  c.tree = parse(c.tokens, c.diagnostics);
  if (options.strict) {
    check_strict(c.tree, c.sources, c.diagnostics);
  }
  if (options.until == Stage::Syntax) {
    return c;
  }
  c.system = resolve(c.tree, c.sources, importer, c.diagnostics);
  if (c.diagnostics.has_errors() || options.until == Stage::System) {
    return c;
  }
  if (!options.method.empty()) {
    c.system->integration.method = options.method;
  }
  c.equations = mechanics::formulate(*c.system, *c.graph);
  if (options.until == Stage::Equations) {
    return c;
  }
  c.derivatives = mechanics::differentiate(*c.system, c.equations, *c.graph);
  const auto start = options.assembles ? mechanics::Start::Assembled : mechanics::Start::Consistent;
  c.examination = examine(*c.system, c.equations, c.derivatives, start, c.diagnostics);
  if (c.diagnostics.has_errors() || options.until == Stage::Derivatives) {
    return c;
  }
  const bool with_series =
      needs(c.system->integration, model::Code::Series) && !mechanics::find_changing_inertia(c.derivatives);
  c.program = schedule(*c.system, c.equations, c.derivatives, *c.graph, with_series);
  return c;
}

}  // namespace mbcc
