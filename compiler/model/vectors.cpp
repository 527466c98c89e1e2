// The part of the algebra that is about vectors.

#include "model/algebra.hpp"

namespace mbcc::model {

using graph::Operator;

Value Algebra::dot(const Operand& left, const Operand& right, Span whole) {
  const Value& a = left.value;
  const Value& b = right.value;
  if (a.is_nothing() || b.is_nothing()) {
    return {};
  }
  if (a.size() != b.size()) {
    context_.report.report(Finding::VectorOperands, whole, "dot", "two vectors of one length", describe(a),
                           describe(b));
    return {};
  }
  Value total = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool is_square = a[i].node && a[i].node == b[i].node;
    const std::optional<Scalar> term =
        is_square ? compute(Operator::Power, {a[i], {2, std::nullopt}}, whole) : product(a[i], b[i], whole);
    if (!term) {
      return {};
    }
    total = add({total, whole}, {*term, whole}, whole, whole);
  }
  return total;
}

Value Algebra::cross(const Operand& left, const Operand& right, Span whole) {
  const Value& a = left.value;
  const Value& b = right.value;
  if (a.is_nothing() || b.is_nothing()) {
    return {};
  }
  if (a.is_scalar() || a.size() != b.size()) {
    context_.report.report(Finding::VectorOperands, whole, "cross", "two vectors of one length", describe(a),
                           describe(b));
    return {};
  }
  const auto minor = [&](std::size_t i, std::size_t j) -> std::optional<Scalar> {
    const auto first = product(a[i], b[j], whole);
    const auto second = product(a[j], b[i], whole);
    if (!first || !second) {
      return std::nullopt;
    }
    const Value difference = subtract({*first, whole}, {*second, whole}, whole, whole);
    return difference.is_nothing() ? std::nullopt : std::optional(difference[0]);
  };
  if (a.size() == 2) {
    return each(1, [&](std::size_t) { return minor(0, 1); });
  }
  return each(3, [&](std::size_t i) { return minor((i + 1) % 3, (i + 2) % 3); });
}

Value Algebra::norm(const Operand& operand, Span whole) {
  const Value square = dot(operand, operand, whole);
  if (square.is_nothing()) {
    return {};
  }
  const Operator root = operand.value.is_scalar() ? Operator::Abs : Operator::Sqrt;
  const Scalar& radicand = operand.value.is_scalar() ? operand.value[0] : square[0];
  const std::optional<Scalar> norm = compute(root, {radicand}, whole);
  if (norm && norm->node) {
    squares_of_norms_.emplace(index(*norm->node), square[0]);
  }
  return norm ? Value(*norm) : Value();
}

}  // namespace mbcc::model
