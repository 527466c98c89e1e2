#include "resolved.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "diagnostics/render.hpp"
#include "model/expression_text.hpp"
#include "syntax/parser.hpp"

namespace mbcc::test {
namespace {

/// The name of the file that `importing` calls `path`.
std::string relative_to(const std::string& importing, const std::string& path) {
  return (std::filesystem::path(importing).parent_path() / path).lexically_normal().string();
}

}  // namespace

std::string Resolved::messages() const { return render(diagnostics, sources); }

Resolved resolve_files(const Files& files, const std::string& name) {
  Resolved resolved;
  Sources& sources = resolved.sources;
  Diagnostics& diagnostics = resolved.diagnostics;
  const auto read = [&](const std::string& path) -> std::optional<ImportedFile> {
    const auto found = files.find(path);
    if (found == files.end()) {
      return std::nullopt;
    }
    const std::uint32_t file = sources.add(path, found->second);
    return ImportedFile{file, parse(lex(sources, file, diagnostics), diagnostics)};
  };
  const Importer import = [&](const std::string& path, std::uint32_t importing) {
    return read(relative_to(sources[importing].name(), path));
  };
  const ast::ModelFile model = read(name)->model;
  resolved.system = resolve(model, sources, import, diagnostics);
  return resolved;
}

Resolved resolve_text(const std::string& text) { return resolve_files({{"model.mbd", text}}, "model.mbd"); }

model::System system_of(const std::string& text) {
  Resolved resolved = resolve_text(text);
  INFO(resolved.messages());
  REQUIRE(resolved.diagnostics.all().empty());
  REQUIRE(resolved.system);
  return *resolved.system;
}

std::string printed(const std::string& text) { return print(system_of(text)); }

std::string shown(const std::string& expression, const std::string& more) {
  const Resolved resolved = resolve_text(
      "parameter k = 2\nparameter m = 3\n"
      "particle 1 { mass = 1; position = (1, 0, 0) }\n"
      "particle 2 { mass = 1; position = (2, 0, 0) }\n"
      "particle bob { mass = 1; position = (3, 0, 0) }\n" +
      more + "\noutput shown = " + expression + "\n");
  INFO(resolved.messages());
  REQUIRE(resolved.system);
  const model::ExpressionText text(*resolved.system);
  std::string all;
  for (const std::string& named : text.named()) {
    all += named + "; ";
  }
  for (const model::Output& output : resolved.system->outputs) {
    all += (all.empty() || all.back() == ' ' ? "" : ", ") + text(output.value);
  }
  return all;
}

}  // namespace mbcc::test
