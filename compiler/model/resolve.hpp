#pragma once
// Syntax tree to System: names become ids, loops and sums are unrolled, every rule of the language is checked.

#include <functional>
#include <optional>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "model/system.hpp"
#include "syntax/ast.hpp"

namespace mbcc {

/// Reads the file that an `import` names, relative to the importing one: adds it to `Sources`, lexes and parses it.
/// Empty if it cannot be read.
struct ImportedFile {
  std::uint32_t file;
  ast::ModelFile model;
};
using Importer = std::function<std::optional<ImportedFile>(const std::string& path, std::uint32_t importing_file)>;

/// Empty if and only if it reported an error.
std::optional<model::System> resolve(const ast::ModelFile& file, const Sources& sources, const Importer& import,
                                     Diagnostics& diagnostics);

std::string print(const model::System& system);  ///< for `dump --stage=system`

}  // namespace mbcc
