#pragma once
// The front end on any bytes, and what must hold whatever they are.

#include <string>

#include "diagnostics/assert.hpp"
#include "diagnostics/render.hpp"
#include "syntax/parser.hpp"

namespace mbcc::fuzz {

struct ReadModel {
  Sources sources;
  Diagnostics diagnostics;
  ast::ModelFile tree;
};

inline bool is_within(Span span, std::size_t size) { return span.begin <= span.end && span.end <= size; }

/// Lexes, parses, prints and renders; a broken promise ends the program.
inline ReadModel read_model(std::string text) {
  ReadModel model;
  const std::size_t size = text.size();
  model.sources.add("model.mbd", std::move(text));
  const TokenBuffer tokens = lex(model.sources, 0, model.diagnostics);
  std::uint32_t end = 0;
  for (const Token& token : tokens) {
    MBCC_ASSERT(is_within(token.span, size) && token.span.begin >= end);
    end = token.span.end;
  }
  MBCC_ASSERT(tokens.back().kind == TokenKind::EndOfFile);
  model.tree = parse(tokens, model.diagnostics);
  check_strict(model.tree, model.sources, model.diagnostics);
  for (const Diagnostic& diagnostic : model.diagnostics.all()) {
    MBCC_ASSERT(is_within(diagnostic.span, size));
    for (const Note& note : diagnostic.notes) {
      MBCC_ASSERT(is_within(note.span, size));
    }
  }
  MBCC_ASSERT(model.diagnostics.all().empty() == render(model.diagnostics, model.sources).empty());
  MBCC_ASSERT(print(tokens, model.sources).size() >= tokens.size());
  MBCC_ASSERT(model.tree.statements.empty() == print(model.tree).empty());
  return model;
}

}  // namespace mbcc::fuzz
