#include "model/expression_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "model/arena.hpp"

namespace mbcc::model {
namespace {

/// Deeper expressions than this are written in parts: writing recurses.
constexpr int deepest = 100;

}  // namespace

ExpressionText::ExpressionText(const System& system) : system_(system), names_(system.expressions.size()) {
  std::vector<int> uses(names_.size());
  std::vector<int> depths(names_.size());
  for (const Expression& expression : system.expressions) {
    for (std::size_t k = 0; k < operand_count(expression); ++k) {
      ++uses[index(expression.operands[k])];
    }
  }
  for (std::size_t i = 0; i < names_.size(); ++i) {
    const Expression& expression = system.expressions[i];
    for (std::size_t k = 0; k < operand_count(expression); ++k) {
      depths[i] = std::max(depths[i], depths[index(expression.operands[k])] + 1);
    }
    if (operand_count(expression) > 0 && (uses[i] > 1 || depths[i] > deepest)) {
      const std::string text = write(expression);
      names_[i] = fmt::format("${}", named_.size() + 1);
      named_.push_back(fmt::format("{} = {}", names_[i], text));
      depths[i] = 0;
    }
  }
}

ExpressionText::Binding ExpressionText::binding(const Expression& expression) {
  if (expression.kind == ExpressionKind::Number) {
    return expression.number < 0 ? Binding::Sign : Binding::Operand;
  }
  return expression.kind == ExpressionKind::Apply ? graph::precedence(expression.op) : Binding::Operand;
}

/// `around` is the weakest binding that needs no parentheses here.
std::string ExpressionText::write(ExpressionId id, Binding around) const {
  if (!names_[index(id)].empty()) {
    return names_[index(id)];
  }
  const Expression& expression = system_[id];
  const std::string text = write(expression);
  return binding(expression) < around ? "(" + text + ")" : text;
}

std::string ExpressionText::write(const Expression& expression) const {
  switch (expression.kind) {
    case ExpressionKind::Number:
      return fmt::to_string(expression.number);
    case ExpressionKind::Time:
      return "t";
    case ExpressionKind::Coordinate:
      return system_.coordinates[expression.index].name;
    case ExpressionKind::Speed:
      return system_.speeds[expression.index].name;
    case ExpressionKind::Parameter:
      return system_.parameters[expression.index].name;
    case ExpressionKind::Rate:
      return write(expression.operands[0], Binding::Operand) + "'";
    case ExpressionKind::Apply:
      return write_application(expression);
  }
  return {};
}

std::string ExpressionText::write_application(const Expression& expression) const {
  const graph::OperatorRow& row = graph::row(expression.op);
  const Binding own = binding(expression);
  const auto& [a, b, c] = expression.operands;
  switch (own) {
    case Binding::Comparison:
    case Binding::Sum:
      return fmt::format("{} {} {}", write(a, own), row.spelling, write(b, tighter(own)));
    case Binding::Product:
      return fmt::format("{}{}{}", write(a, own), row.spelling, write(b, tighter(own)));
    case Binding::Power:
      return fmt::format("{}^{}", write(a, tighter(own)), write(b, tighter(own)));
    case Binding::Sign:
      return fmt::format("-{}", write(a, tighter(own)));
    default:
      break;
  }
  std::string arguments = write(a, Binding::Nothing);
  for (std::size_t k = 1; k < operand_count(expression); ++k) {
    arguments += ", " + write(expression.operands[k], Binding::Nothing);
  }
  return fmt::format("{}({})", row.spelling, arguments);
}

}  // namespace mbcc::model
