#pragma once
// Tokens to syntax tree, by the grammar of grammar/model.ebnf.

#include <string>

#include "diagnostics/diagnostic.hpp"
#include "syntax/ast.hpp"
#include "syntax/token.hpp"

namespace mbcc {

/// Reports every statement that does not follow the grammar and goes on with the next one.
ast::ModelFile parse(const TokenBuffer& tokens, Diagnostics& diagnostics);

/// Reports each expression of a force component or constraint that the paper's own grammar (grammar/paper.ebnf)
/// would refuse.
void check_strict(const ast::ModelFile& model, const Sources& sources, Diagnostics& diagnostics);

std::string print(const TokenBuffer& tokens, const Sources& sources);  ///< for `dump --stage=tokens`
std::string print(const ast::ModelFile& model);                        ///< for `dump --stage=syntax`

}  // namespace mbcc
