#include "model/warnings.hpp"

#include <fmt/format.h>

#include <type_traits>

namespace mbcc::model {
namespace {

using Expressions = std::vector<const ast::Expression*>;

void append(Expressions& all, const std::vector<ast::Expression>& more) {
  for (const ast::Expression& expression : more) {
    all.push_back(&expression);
  }
}

struct Children {
  Expressions& all;

  void operator()(const ast::Number& /*number*/) const {}
  void operator()(const ast::Reference& reference) const {
    for (const ast::Step& step : reference.steps) {
      append(all, step.indices);
    }
  }
  void operator()(const ast::Unary& unary) const { append(all, unary.operand); }
  void operator()(const ast::Binary& binary) const { append(all, binary.operands); }
  void operator()(const ast::Comparison& comparison) const { append(all, comparison.operands); }
  void operator()(const ast::Call& call) const { append(all, call.arguments); }
  void operator()(const ast::Vector& vector) const { append(all, vector.components); }
  void operator()(const ast::Parenthesised& parenthesised) const { append(all, parenthesised.inner); }
  void operator()(const ast::Rate& rate) const { append(all, rate.operand); }
  void operator()(const ast::Sum& sum) const {
    append(all, sum.bounds);
    append(all, sum.body);
  }
};

void collect(const std::vector<ast::Field>& fields, Expressions& all) {
  for (const ast::Field& field : fields) {
    all.push_back(&field.value);
  }
}

void collect(const ast::Statement& statement, Expressions& all);

void collect(const std::vector<ast::Statement>& statements, Expressions& all) {
  for (const ast::Statement& statement : statements) {
    collect(statement, all);
  }
}

void collect(const ast::Statement& statement, Expressions& all) {
  const auto of_node = [&](const auto& node) {
    using Node = std::decay_t<decltype(node)>;
    if constexpr (std::is_same_v<Node, ast::Particle> || std::is_same_v<Node, ast::Variable> ||
                  std::is_same_v<Node, ast::Integrate>) {
      collect(node.fields, all);
    } else if constexpr (std::is_same_v<Node, ast::Constraint>) {
      append(all, node.sides);
    } else if constexpr (std::is_same_v<Node, ast::Module>) {
      for (const ast::Formal& formal : node.formals) {
        if (formal.value) {
          all.push_back(&*formal.value);
        }
      }
      collect(node.body, all);
    } else if constexpr (std::is_same_v<Node, ast::Part>) {
      collect(node.arguments, all);
      collect(node.ports, all);
    } else if constexpr (std::is_same_v<Node, ast::For>) {
      append(all, node.bounds);
      collect(node.body, all);
    } else if constexpr (!std::is_same_v<Node, ast::System> && !std::is_same_v<Node, ast::Import> &&
                         !std::is_same_v<Node, ast::Port> && !std::is_same_v<Node, ast::Unsupported>) {
      all.push_back(&node.value);
    }
  };
  std::visit(of_node, statement.node);
}

const ast::Binary* as_power(const ast::Expression& expression) {
  const auto* binary = std::get_if<ast::Binary>(&expression.node);
  return binary != nullptr && binary->op == ast::BinaryOperator::Power ? binary : nullptr;
}

void warn_of_power(const ast::Expression& expression, Context& context) {
  const ast::Binary* outer = as_power(expression);
  if (outer != nullptr && as_power(outer->operands[0]) != nullptr) {
    const auto text = [&](const ast::Expression& part) { return context.sources.text(part.span); };
    context.report.report(Finding::PowerOfPower, expression.span, text(expression),
                          fmt::format("({})^{}", text(outer->operands[0]), text(outer->operands[1])));
  }
}

/// How a message calls it; empty for what need not be used. A module's names are there for those who use the module.
std::string_view kind_to_warn_of(const Definition& definition) {
  switch (definition.kind) {
    case SymbolKind::Parameter:
    case SymbolKind::Formal:
      return "parameter";
    case SymbolKind::Port:
      return "port";
    case SymbolKind::Let:
      return definition.frame->scope->is_part() && !is_in_loop(definition.frame) ? "" : "`let`";
    default:
      return {};
  }
}

}  // namespace

void warn_of_unused(Context& context) {
  for (const Definition& definition : context.symbols.definitions) {
    const std::string_view kind = kind_to_warn_of(definition);
    if (!kind.empty() && context.symbols.used.count(definition.declarator) == 0) {
      context.report.report(Finding::Unused, definition.declarator->span, kind, definition.declarator->name);
    }
  }
}

void warn_of_powers(const std::vector<const ast::Statement*>& statements, Context& context) {
  Expressions open;
  for (const ast::Statement* statement : statements) {
    collect(*statement, open);
  }
  while (!open.empty()) {
    const ast::Expression& expression = *open.back();
    open.pop_back();
    warn_of_power(expression, context);
    std::visit(Children{open}, expression.node);
  }
}

}  // namespace mbcc::model
