#include "emit/code.hpp"

#include <fmt/format.h>

#include <cmath>

#include "diagnostics/assert.hpp"

namespace mbcc::cpp {

namespace {

using graph::Operator;

std::string bound(const Code& code, Binding at_least) {
  return code.binding < at_least ? fmt::format("({})", code.text) : code.text;
}

/// a op b, where b has to bind more tightly: a - (b - c).
Code infix(Operator op, Binding binding, const Code& a, const Code& b) {
  const auto tighter = static_cast<Binding>(static_cast<int>(binding) + 1);
  return {fmt::format("{} {} {}", bound(a, binding), graph::row(op).code, bound(b, tighter)), binding};
}

Code call(Operator op, const std::vector<Code>& operands) {
  std::string text = std::string(graph::row(op).code) + "(";
  for (std::size_t i = 0; i < operands.size(); ++i) {
    text += (i == 0 ? "" : ", ") + operands[i].text;
  }
  return {text + ")", Binding::Primary};
}

}  // namespace

Code literal(double value) {
  MBCC_ASSERT(std::isfinite(value));
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) {
    text += ".0";
  }
  return {text, std::signbit(value) ? Binding::Prefix : Binding::Primary};
}

Code compose(Operator op, const std::vector<Code>& operands) {
  switch (op) {
    case Operator::Add:
    case Operator::Subtract:
      return infix(op, Binding::Sum, operands[0], operands[1]);
    case Operator::Multiply:
    case Operator::Divide:
      return infix(op, Binding::Product, operands[0], operands[1]);
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Equal:
      return infix(op, Binding::Comparison, {bound(operands[0], Binding::Sum), Binding::Primary}, operands[1]);
    case Operator::Negate:
      return {"-" + bound(operands[0], Binding::Primary), Binding::Prefix};
    case Operator::If: {
      const Code& condition = operands[0];
      const std::string holds =
          condition.binding == Binding::Comparison ? condition.text : bound(condition, Binding::Sum) + " != 0.0";
      return {fmt::format("{} ? {} : {}", holds, bound(operands[1], Binding::Sum), bound(operands[2], Binding::Sum)),
              Binding::Conditional};
    }
    default:
      return call(op, operands);
  }
}

std::string affine(long first, long stride, const std::string& i) {
  if (stride == 0) {
    return std::to_string(first);
  }
  const std::string steps = std::abs(stride) == 1 ? i : fmt::format("{} * {}", std::abs(stride), i);
  if (stride < 0) {
    return fmt::format("{} - {}", first, steps);
  }
  return first == 0 ? steps : fmt::format("{} + {}", steps, first);
}

}  // namespace mbcc::cpp
