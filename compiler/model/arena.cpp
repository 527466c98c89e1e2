#include "model/arena.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "diagnostics/assert.hpp"
#include "graph/evaluate.hpp"

namespace mbcc::model {
namespace {

Quantities quantity_of(ExpressionKind kind) {
  switch (kind) {
    case ExpressionKind::Time:
      return Quantities::Time;
    case ExpressionKind::Coordinate:
      return Quantities::Coordinate;
    case ExpressionKind::Speed:
      return Quantities::Speed;
    case ExpressionKind::Parameter:
      return Quantities::Parameter;
    default:
      return Quantities::None;
  }
}

/// What the time derivative of something depends on, beside what that depends on itself.
Quantities brought_by_rate(Quantities operand) {
  const bool moves = overlap(operand, Quantities::Coordinate);
  const bool accelerates = overlap(operand, Quantities::Speed);
  return (moves ? Quantities::Speed : Quantities::None) | (accelerates ? Quantities::Acceleration : Quantities::None);
}

double fold(graph::Operator op, std::initializer_list<Scalar> operands) {
  std::array<const double*, 3> numbers{};
  std::size_t count = 0;
  for (const Scalar& operand : operands) {
    numbers[count++] = &operand.number;
  }
  return graph::perform<double>(op, numbers);
}

}  // namespace

Scalar Arena::leaf(ExpressionKind kind, std::uint32_t index, Span span) {
  Expression leaf;
  leaf.kind = kind;
  leaf.index = index;
  leaf.span = span;
  return append(leaf, quantity_of(kind));
}

Scalar Arena::apply(graph::Operator op, std::initializer_list<Scalar> operands, Span span) {
  MBCC_ASSERT(static_cast<int>(operands.size()) == graph::arity(op));
  if (std::all_of(operands.begin(), operands.end(), [](const Scalar& operand) { return operand.is_number(); })) {
    return {fold(op, operands), std::nullopt};
  }
  Expression application;
  application.kind = ExpressionKind::Apply;
  application.op = op;
  application.span = span;
  Quantities all = Quantities::None;
  std::size_t count = 0;
  for (const Scalar& operand : operands) {
    application.operands[count++] = node(operand, span);
    all = all | quantities(operand);
  }
  return append(application, all);
}

Scalar Arena::rate(Scalar operand, Span span) {
  const Quantities of_operand = quantities(operand);
  if (!overlap(of_operand, Quantities::Time | Quantities::Coordinate | Quantities::Speed)) {
    return {};
  }
  Expression rate;
  rate.kind = ExpressionKind::Rate;
  rate.operands[0] = *operand.node;
  rate.span = span;
  return append(rate, of_operand | brought_by_rate(of_operand));
}

std::vector<CoordinateId> Arena::coordinates_of(const Value& position) const {
  std::set<CoordinateId> found;
  std::set<ExpressionId> seen;
  std::vector<ExpressionId> open;
  for (const Scalar& component : position) {
    if (component.node) {
      open.push_back(*component.node);
    }
  }
  while (!open.empty()) {
    const ExpressionId id = open.back();
    open.pop_back();
    if (!seen.insert(id).second) {
      continue;
    }
    const Expression& expression = expressions_[index(id)];
    if (expression.kind == ExpressionKind::Coordinate) {
      found.insert(CoordinateId{expression.index});
    }
    open.insert(open.end(), expression.operands.begin(),
                expression.operands.begin() + static_cast<std::ptrdiff_t>(operand_count(expression)));
  }
  return {found.begin(), found.end()};
}

ExpressionId Arena::node(Scalar scalar, Span span) {
  if (scalar.node) {
    return *scalar.node;
  }
  const auto [known, is_new] = numbers_.try_emplace(std::bit_cast<std::uint64_t>(scalar.number));
  if (is_new) {
    Expression number;
    number.number = scalar.number;
    number.span = span;
    known->second = *append(number, Quantities::None).node;
  }
  return known->second;
}

Scalar Arena::scalar(ExpressionId id) const {
  const Expression& expression = expressions_[index(id)];
  return expression.kind == ExpressionKind::Number ? Scalar{expression.number, std::nullopt} : Scalar{0, id};
}

const Expression& Arena::source_of(const Scalar& scalar, Quantities unwanted) const {
  ExpressionId id = *scalar.node;
  while (true) {
    const Expression& expression = expressions_[index(id)];
    const auto end = expression.operands.begin() + static_cast<std::ptrdiff_t>(operand_count(expression));
    const auto next = std::find_if(expression.operands.begin(), end, [&](ExpressionId operand) {
      return overlap(quantities_[index(operand)], unwanted);
    });
    if (next == end) {
      return expression;
    }
    id = *next;
  }
}

Scalar Arena::append(const Expression& expression, Quantities quantities) {
  expressions_.push_back(expression);
  quantities_.push_back(quantities);
  return {0, ExpressionId{static_cast<std::uint32_t>(expressions_.size() - 1)}};
}

std::size_t operand_count(const Expression& expression) {
  switch (expression.kind) {
    case ExpressionKind::Apply:
      return static_cast<std::size_t>(graph::arity(expression.op));
    case ExpressionKind::Rate:
      return 1;
    default:
      return 0;
  }
}

}  // namespace mbcc::model
