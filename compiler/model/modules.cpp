#include "model/modules.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/spelling.hpp"

namespace mbcc::model {
namespace {

using Given = std::map<std::string_view, const ast::Field*>;

/// Parts inside one another, each of another module.
constexpr int most_levels = 100;

/// What a model of a single module may have beside it.
bool is_setting(const ast::Statement& statement) {
  return std::holds_alternative<ast::System>(statement.node) ||
         std::holds_alternative<ast::Dimension>(statement.node) ||
         std::holds_alternative<ast::Gravity>(statement.node) || std::holds_alternative<ast::Integrate>(statement.node);
}

/// Whether `module` is the module of a part among `statements`, their loops included.
bool uses(const std::vector<ast::Statement>& statements, const ast::Module& module) {
  return std::any_of(statements.begin(), statements.end(), [&](const ast::Statement& statement) {
    const auto* part = std::get_if<ast::Part>(&statement.node);
    const auto* loop = std::get_if<ast::For>(&statement.node);
    return (part != nullptr && part->module == module.name.name) || (loop != nullptr && uses(loop->body, module));
  });
}

void refuse_in_module(const ast::Module& module, Context& context) {
  for (const ast::Statement& statement : module.body) {
    if (std::holds_alternative<ast::System>(statement.node) || std::holds_alternative<ast::Import>(statement.node) ||
        std::holds_alternative<ast::Module>(statement.node)) {
      const std::string what = fmt::format("`{}`", context.sources.text(statement.keyword_span));
      context.report.report(Finding::NotInModule, statement.keyword_span, what, "");
    }
  }
}

std::vector<std::string_view> names_of_ports(const ast::Module& module) {
  std::vector<std::string_view> names;
  for (const ast::Statement& statement : module.body) {
    if (const auto* point = std::get_if<ast::Point>(&statement.node); point && point->name.indices.empty()) {
      names.push_back(point->name.name);
    } else if (const auto* port = std::get_if<ast::Port>(&statement.node)) {
      names.push_back(port->name.name);
    }
  }
  return names;
}

Given given_by(const std::vector<ast::Field>& fields, std::string_view kind, const ast::Module& module,
               const std::vector<std::string_view>& known, Context& context) {
  Given given;
  for (const ast::Field& field : fields) {
    if (std::find(known.begin(), known.end(), field.name) == known.end()) {
      context.report
          .report(Finding::UnknownInModule, field.name_span, module.name.name, kind, field.name,
                  suggestion(field.name, known))
          .note(module.name.span, fmt::format("module `{}` is declared here", module.name.name));
    } else if (const auto [first, is_new] = given.try_emplace(field.name, &field); !is_new) {
      context.report.report(Finding::GivenTwice, field.name_span, field.name)
          .note(first->second->name_span, "first given here");
    }
  }
  return given;
}

void take_given(Definition& definition, std::string_view kind, const Given& given, const Scope& scope,
                Context& context) {
  const auto found = given.find(definition.declarator->name);
  if (found != given.end()) {
    definition.expression = &found->second->value;
    definition.frame = scope.made_in;
  } else if (definition.expression == nullptr && !scope.is_part()) {
    context.report.report(Finding::NoDefault, definition.declarator->span, scope.module->name.name, kind,
                          definition.declarator->name);
  } else if (definition.expression == nullptr) {
    const std::string& name = definition.declarator->name;
    const Reporter::Within outside(context.report, scope.made_in->scope->trace);
    const std::string_view brackets = definition.kind == SymbolKind::Formal ? "({} = ...)" : "{{ {} = ... }}";
    context.report
        .report(Finding::NotGiven, scope.trace.span, scope.name, kind, name, fmt::format(fmt::runtime(brackets), name))
        .note(definition.declarator->span, fmt::format("`{}` is declared here", name));
  }
}

}  // namespace

void let_module_stand_alone(Statements& statements) {
  std::vector<const ast::Module*> modules;
  for (const ast::Statement* statement : statements.all) {
    const auto* module = std::get_if<ast::Module>(&statement->node);
    if (module != nullptr && statement->span.file == 0) {
      modules.push_back(module);
    } else if (module == nullptr && !is_setting(*statement)) {
      return;
    }
  }
  const auto is_used = [&](const ast::Module* module) {
    return std::any_of(modules.begin(), modules.end(),
                       [&](const ast::Module* other) { return uses(other->body, *module); });
  };
  modules.erase(std::remove_if(modules.begin(), modules.end(), is_used), modules.end());
  if (modules.size() == 1) {
    statements.alone = modules.front();
    const std::vector<const ast::Statement*> body = statements_of(*statements.alone);
    statements.all.insert(statements.all.end(), body.begin(), body.end());
  }
}

void collect_modules(const std::vector<const ast::Statement*>& statements, Context& context) {
  for (const ast::Statement* statement : statements) {
    const auto* module = std::get_if<ast::Module>(&statement->node);
    if (module == nullptr) {
      continue;
    }
    const auto [entry, is_new] = context.symbols.modules.try_emplace(module->name.name, module);
    if (!is_new) {
      context.report.report(Finding::AlreadyDeclared, module->name.span, module->name.name)
          .note(entry->second->name.span, "first declared here");
    }
    refuse_in_module(*module, context);
  }
}

std::vector<const ast::Statement*> statements_of(const ast::Module& module) {
  std::vector<const ast::Statement*> statements;
  for (const ast::Statement& statement : module.body) {
    statements.push_back(&statement);
  }
  return statements;
}

bool is_port(const ast::Statement& statement) {
  const auto* point = std::get_if<ast::Point>(&statement.node);
  return std::holds_alternative<ast::Port>(statement.node) || (point != nullptr && point->name.indices.empty());
}

const ast::Module* find_module(const ast::Part& part, const Scope& around, Context& context) {
  const auto found = context.symbols.modules.find(part.module);
  if (found == context.symbols.modules.end()) {
    std::vector<std::string_view> names;
    for (const auto& entry : context.symbols.modules) {
      names.push_back(entry.first);
    }
    if (!context.report.statements_are_lost()) {
      context.report.report(Finding::UnknownModule, part.module_span, part.module, suggestion(part.module, names));
    }
    return nullptr;
  }
  int levels = 0;
  for (const Scope* scope = &around; scope != nullptr; scope = scope->is_part() ? scope->made_in->scope : nullptr) {
    if (scope->module == found->second) {
      context.report.report(Finding::ContainsItself, part.module_span, part.module);
      return nullptr;
    }
    if (++levels > most_levels) {
      context.report.report(Finding::TooDeep, part.name.span, most_levels);
      context.budget.exhaust();
      return nullptr;
    }
  }
  return found->second;
}

Given arguments_of(const ast::Part& part, const Scope& scope, Context& context) {
  std::vector<std::string_view> known;
  for (const ast::Formal& formal : scope.module->formals) {
    known.push_back(formal.name.name);
  }
  return given_by(part.arguments, "parameter", *scope.module, known, context);
}

Given ports_of(const ast::Part& part, const Scope& scope, Context& context) {
  return given_by(part.ports, "port", *scope.module, names_of_ports(*scope.module), context);
}

void bind_formal(Definition& formal, const Scope& scope, Context& context) {
  take_given(formal, "parameter", scope.arguments, scope, context);
}

void bind_port(Definition& port, const Scope& scope, Context& context) {
  if (scope.module != nullptr) {
    take_given(port, "port", scope.ports, scope, context);
  }
}

}  // namespace mbcc::model
