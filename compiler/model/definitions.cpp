// Constants, parameters and `let`: evaluated once, when first used.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/evaluator.hpp"

namespace mbcc::model {

Value Evaluator::value_of(Definition& definition, Span use) {
  context_.symbols.used.insert(definition.declarator);
  if (definition.kind == SymbolKind::Formal && !structural_.empty()) {
    return known_value_of(definition, use);
  }
  if (definition.kind != SymbolKind::Constant &&
      refuse_unless_structural(definition.name, describe(definition.kind), use)) {
    return {};
  }
  if (definition.kind == SymbolKind::Parameter) {
    return context_.arena.leaf(ExpressionKind::Parameter, index(definition.parameter), use);
  }
  return evaluate(definition);
}

/// Keeps the state of a definition while it is evaluated.
template <class Evaluation>
Value Evaluator::activate(Definition& definition, const Evaluation& evaluation) {
  if (definition.state == Definition::State::Active) {
    report_cycle(definition);
    return {};
  }
  definition.state = Definition::State::Active;
  active_.push_back(&definition);
  definition.value = evaluation();
  active_.pop_back();
  definition.state = Definition::State::Done;
  return definition.value;
}

Value Evaluator::evaluate(Definition& definition) {
  if (definition.state == Definition::State::Done || definition.expression == nullptr) {
    return definition.value;
  }
  return activate(definition, [&]() -> Value {
    const Reporter::Within within(context_.report, definition.frame->scope->trace);
    switch (definition.kind) {
      case SymbolKind::Constant:
        return known(*definition.expression, definition.frame, "the value of a constant");
      case SymbolKind::Parameter:
        return known(*definition.expression, definition.frame, default_of_parameter);
      case SymbolKind::Point:
      case SymbolKind::Port:
        return position_of(definition);
      default:
        return evaluate(*definition.expression, definition.frame);
    }
  });
}

Value Evaluator::known(const ast::Expression& expression, const Frame* frame, std::string_view what) {
  const std::optional<double> number = structural(expression, frame, what);
  return number ? Value(*number) : Value();
}

/// Of a parameter of a module where only what is known when compiling may stand: so must be what it is given.
Value Evaluator::known_value_of(Definition& formal, Span use) {
  if (formal.is_known || formal.expression == nullptr) {
    return formal.value;
  }
  formal.is_known = true;
  return activate(formal, [&] {
    const Trace needed{use, fmt::format("`{}` is needed here", formal.name), &formal.frame->scope->trace};
    const Reporter::Within within(context_.report, needed);
    return known(*formal.expression, formal.frame, structural_);
  });
}

Value Evaluator::position_of(const Definition& point) {
  const Operand position{evaluate(*point.expression, point.frame), point.expression->span};
  const std::string what = fmt::format("the position of `{}`", point.name);
  const Quantities unwanted = Quantities::Speed | Quantities::Acceleration;
  return algebra_.expect_independent(position, unwanted, what) ? algebra_.expect_vector(position, what) : Value();
}

void Evaluator::report_cycle(const Definition& definition) {
  const auto first = std::find(active_.begin(), active_.end(), &definition);
  std::string path = fmt::format("`{}`", definition.name);
  for (auto step = first + 1; step != active_.end(); ++step) {
    path += fmt::format(" needs `{}`", (*step)->name);
  }
  path += fmt::format(" needs `{}`", definition.name);
  Diagnostic& finding =
      context_.report.report(Finding::DefinedByItself, definition.declarator->span, definition.name, path);
  for (auto step = first + 1; step != active_.end(); ++step) {
    finding.note((*step)->declarator->span, fmt::format("`{}` is declared here", (*step)->name));
  }
}

}  // namespace mbcc::model
