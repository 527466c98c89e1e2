#pragma once
// Models from text, resolved.

#include <map>
#include <optional>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "model/resolve.hpp"

namespace mbcc::test {

/// Files by the names under which they are imported.
using Files = std::map<std::string, std::string>;

struct Resolved {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<model::System> system;

  std::string messages() const;  ///< rendered as the user sees them
};

/// Of the model `name` among `files`.
Resolved resolve_files(const Files& files, const std::string& name);
Resolved resolve_text(const std::string& text);

/// Of a model that must be without findings.
model::System system_of(const std::string& text);
std::string printed(const std::string& text);

/// How the System shows `expression` as an output of a model of dimension 3 that has parameters k and m, the particles
/// 1, 2 and bob, and the statements `more`.
std::string shown(const std::string& expression, const std::string& more = "");

}  // namespace mbcc::test
