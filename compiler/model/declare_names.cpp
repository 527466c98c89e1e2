#include <fmt/format.h>

#include <algorithm>

#include "model/declare.hpp"

namespace mbcc::model {
namespace {

class NameDeclaration {
 public:
  NameDeclaration(Scope& scope, Context& context) : scope_(scope), context_(context) {}

  void add(const ast::Formal& formal) { add(DeclaredName{SymbolKind::Formal, &formal.name}); }

  void add(const ast::Statement& statement) {
    if (const auto* loop = std::get_if<ast::For>(&statement.node)) {
      loops_.push_back(loop->index);
      for (const ast::Statement& inner : loop->body) {
        add(inner);
      }
      loops_.pop_back();
    } else if (std::holds_alternative<ast::Unsupported>(statement.node)) {
      context_.report.lose_names();
    } else if (const std::optional<DeclaredName> declared = declared_name(statement)) {
      add(*declared);
    }
  }

 private:
  void add(const DeclaredName& declared) {
    const ast::Declarator& declarator = *declared.declarator;
    const bool is_indexed = !declarator.indices.empty();
    const bool is_local = !is_indexed && !loops_.empty();
    const bool is_numbered =
        declarator.number || (is_local && declared.kind == SymbolKind::Particle &&
                              std::find(loops_.begin(), loops_.end(), declarator.name) != loops_.end());
    if (is_numbered || (is_local && declared.kind == SymbolKind::Let)) {
      return;
    }
    const bool stands_once = declared.kind == SymbolKind::Constant || declared.kind == SymbolKind::Port;
    if (!loops_.empty() && stands_once) {
      scope_.refused.insert(declarator.name);
      return;
    }
    if (refuse_reserved(declared)) {
      scope_.refused.insert(declarator.name);
    } else if (is_local) {
      context_.report.report(Finding::NeedsIndex, declarator.span, declarator.name, declarator.name, loops_.back());
      scope_.refused.insert(declarator.name);
    } else {
      enter(declared);
    }
  }

  bool refuse_reserved(const DeclaredName& declared) {
    const std::string& name = declared.declarator->name;
    const std::string_view prefix = "constraint_";
    const bool is_given = declared.kind == SymbolKind::Constraint && name.compare(0, prefix.size(), prefix) == 0 &&
                          name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
    const std::string_view reserved = is_given ? "given to constraints without a name" : reserved_as(name);
    if (!reserved.empty()) {
      context_.report.report(Finding::ReservedName, declared.declarator->span, name, reserved);
    }
    return !reserved.empty();
  }

  void enter(const DeclaredName& declared) {
    const ast::Declarator& declarator = *declared.declarator;
    const auto [entry, is_new] = scope_.table.try_emplace(declarator.name);
    Symbol& symbol = entry->second;
    if (is_new) {
      symbol.kind = declared.kind;
      symbol.span = declarator.span;
      symbol.index_count = declarator.indices.size();
    } else if (symbol.kind != declared.kind || symbol.index_count != declarator.indices.size()) {
      context_.report.report(Finding::AlreadyDeclared, declarator.span, declarator.name)
          .note(symbol.span, "first declared here");
    }
  }

  Scope& scope_;
  Context& context_;
  std::vector<std::string> loops_;  ///< indices of the loops around, outermost first
};

}  // namespace

std::optional<DeclaredName> declared_name(const ast::Statement& statement) {
  if (const auto* let = std::get_if<ast::Let>(&statement.node)) {
    return DeclaredName{SymbolKind::Let, &let->name};
  }
  if (const auto* constant = std::get_if<ast::Constant>(&statement.node)) {
    return DeclaredName{SymbolKind::Constant, &constant->name};
  }
  if (const auto* parameter = std::get_if<ast::Parameter>(&statement.node)) {
    return DeclaredName{SymbolKind::Parameter, &parameter->name};
  }
  if (const auto* particle = std::get_if<ast::Particle>(&statement.node)) {
    return DeclaredName{SymbolKind::Particle, &particle->name};
  }
  if (const auto* variable = std::get_if<ast::Variable>(&statement.node)) {
    return DeclaredName{kind_of(variable->kind), &variable->name};
  }
  if (const auto* constraint = std::get_if<ast::Constraint>(&statement.node); constraint && constraint->label) {
    return DeclaredName{SymbolKind::Constraint, &*constraint->label};
  }
  if (const auto* point = std::get_if<ast::Point>(&statement.node)) {
    return DeclaredName{SymbolKind::Point, &point->name};
  }
  if (const auto* port = std::get_if<ast::Port>(&statement.node)) {
    return DeclaredName{SymbolKind::Port, &port->name};
  }
  if (const auto* part = std::get_if<ast::Part>(&statement.node)) {
    return DeclaredName{SymbolKind::Part, &part->name};
  }
  return std::nullopt;
}

void declare_names(const std::vector<const ast::Statement*>& statements, Scope& scope, Context& context) {
  NameDeclaration declaration(scope, context);
  if (scope.module != nullptr) {
    for (const ast::Formal& formal : scope.module->formals) {
      declaration.add(formal);
    }
  }
  for (const ast::Statement* statement : statements) {
    declaration.add(*statement);
  }
}

void declare_incomplete(const ast::Statement& statement, Scope& scope, Symbols& symbols) {
  if (const auto* loop = std::get_if<ast::For>(&statement.node)) {
    for (const ast::Statement& inner : loop->body) {
      declare_incomplete(inner, scope, symbols);
    }
  } else if (const std::optional<DeclaredName> declared = declared_name(statement)) {
    if (Symbol* symbol = scope.find(declared->declarator->name)) {
      symbol->complete = false;
    } else if (declared->kind == SymbolKind::Particle) {
      symbols.numbers_complete = false;
    }
  }
}

}  // namespace mbcc::model
