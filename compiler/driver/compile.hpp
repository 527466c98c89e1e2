#pragma once
// The whole compiler, one line per pass.

#include <memory>
#include <optional>
#include <string>

#include "diagnostics/diagnostic.hpp"
#include "emit/emit.hpp"
#include "mechanics/derivatives.hpp"
#include "mechanics/examine.hpp"
#include "model/system.hpp"
#include "program/program.hpp"
#include "syntax/ast.hpp"
#include "syntax/token.hpp"

namespace mbcc {

/// The representations, in the order in which they come to be; `until` names the last one wanted.
enum class Stage { Tokens, Syntax, System, Equations, Derivatives, Program };

struct CompileOptions {
  bool strict = false;  ///< forces and constraints in the paper's grammar
  Stage until = Stage::Program;
  bool assembles = false;   ///< the start will be moved onto the constraints: it need not satisfy them
  std::string method = {};  ///< instead of the one that the model's `integrate` names, if not empty
};

/// Every representation of one model that was reached before `until` or an error.
struct Compilation {
  Sources sources;
  Diagnostics diagnostics;
  TokenBuffer tokens;
  ast::ModelFile tree;
  std::optional<model::System> system;
  std::unique_ptr<graph::Graph> graph = std::make_unique<graph::Graph>();
  mechanics::Equations equations;
  mechanics::Derivatives derivatives;
  mechanics::Examination examination;
  std::optional<program::Program> program;

  /// No errors, and no warnings if these count as errors.
  bool succeeded(bool werror) const { return !diagnostics.has_errors() && !(werror && diagnostics.warnings() != 0); }
};

/// `name` is the model file as the user wrote it; imports are read relative to it.
Compilation compile(std::string name, std::string text, const CompileOptions& options);

}  // namespace mbcc
