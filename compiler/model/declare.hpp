#pragma once
// Finds out what a model declares: gives names their meaning and unrolls loops, before any expression is looked into
// that is not a loop bound or an index.

#include <vector>

#include "model/evaluator.hpp"
#include "model/imports.hpp"

namespace mbcc::model {

/// A statement in one part, in one pass of the loops around it.
struct Instance {
  const ast::Statement* statement;
  const Frame* frame;
};

/// Fills the context's symbols and dimension. Returns, in order, all statements but loops and what declares no more
/// than names.
std::vector<Instance> declare(const Statements& statements, Evaluator& evaluator, Context& context);

/// The name that a statement gives to something that expressions may refer to.
struct DeclaredName {
  SymbolKind kind;
  const ast::Declarator* declarator;
};
std::optional<DeclaredName> declared_name(const ast::Statement& statement);

/// Enters the names of `statements`, those of the scope, into its table, as kinds of things without elements, and
/// reports those that cannot be declared.
void declare_names(const std::vector<const ast::Statement*>& statements, Scope& scope, Context& context);

/// Notes that what `statement` declares inside of it is not known.
void declare_incomplete(const ast::Statement& statement, Scope& scope, Symbols& symbols);

}  // namespace mbcc::model
