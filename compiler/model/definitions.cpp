// Constants, parameters and `let`: evaluated once, when first used.

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "model/evaluator.hpp"

namespace mbcc::model {

Value Evaluator::value_of(Definition& definition, Span use) {
  context_.symbols.used.insert(definition.declarator);
  if (definition.kind != SymbolKind::Constant &&
      refuse_unless_structural(definition.name, describe(definition.kind), use)) {
    return {};
  }
  if (definition.kind == SymbolKind::Parameter) {
    return context_.arena.leaf(ExpressionKind::Parameter, index(definition.parameter), use);
  }
  return evaluate(definition);
}

Value Evaluator::evaluate(Definition& definition) {
  switch (definition.state) {
    case Definition::State::Done:
      return definition.value;
    case Definition::State::Active:
      report_cycle(definition);
      return {};
    case Definition::State::Waiting:
      break;
  }
  definition.state = Definition::State::Active;
  active_.push_back(&definition);
  if (definition.kind == SymbolKind::Let) {
    definition.value = evaluate(*definition.expression, definition.frame);
  } else {
    const std::string_view what =
        definition.kind == SymbolKind::Constant ? "the value of a constant" : default_of_parameter;
    const std::optional<double> number = structural(*definition.expression, definition.frame, what);
    definition.value = number ? Value(*number) : Value();
  }
  active_.pop_back();
  definition.state = Definition::State::Done;
  return definition.value;
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
