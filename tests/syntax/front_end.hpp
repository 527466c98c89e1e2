#pragma once
// The front end on a text in memory, for tests.

#include <memory>
#include <string>

#include "diagnostics/render.hpp"
#include "syntax/parser.hpp"

namespace mbcc {

/// A model text, its tokens and tree, and what was found wrong with it.
struct FrontEnd {
  explicit FrontEnd(std::string text) {
    sources.add("model.mbd", std::move(text));
    tokens = lex(sources, 0, diagnostics);
    model = parse(tokens, diagnostics);
  }

  std::string messages() const { return render(diagnostics, sources); }
  bool accepted() const { return !diagnostics.has_errors(); }

  Sources sources;
  Diagnostics diagnostics;
  TokenBuffer tokens;
  ast::ModelFile model;
};

/// The same with the paper's grammar for forces and constraints.
struct StrictFrontEnd : FrontEnd {
  explicit StrictFrontEnd(std::string text) : FrontEnd(std::move(text)) { check_strict(model, sources, diagnostics); }
};

}  // namespace mbcc
