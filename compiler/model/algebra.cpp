#include "model/algebra.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/names.hpp"

namespace mbcc::model {

using graph::Operator;

std::string describe(const Value& value) {
  return value.is_scalar() ? "a number" : "a vector of " + count_of(value.size(), "component");
}

std::optional<Scalar> Algebra::compute(Operator op, std::initializer_list<Scalar> operands, Span whole) {
  const Scalar result = context_.arena.apply(op, operands, whole);
  if (result.is_number() && !std::isfinite(result.number)) {
    const bool has_pole = op == Operator::Ln || op == Operator::Log || op == Operator::Atanh;
    const Finding finding = std::isnan(result.number) || has_pole ? Finding::NoRealValue : Finding::Overflow;
    context_.report.report(finding, whole, context_.sources.text(whole));
    return std::nullopt;
  }
  return result;
}

bool Algebra::expect_number(const Operand& operand, std::string_view what) {
  if (operand.value.is_vector()) {
    context_.report.report(Finding::NumberExpected, operand.span, what, describe(operand.value));
  }
  return operand.value.is_scalar();
}

Value Algebra::negate(const Operand& operand, Span whole) {
  return each(operand.value.size(),
              [&](std::size_t i) { return compute(Operator::Negate, {operand.value[i]}, whole); });
}

Value Algebra::add(const Operand& left, const Operand& right, Span sign, Span whole) {
  return left.value.is_zero() && !right.value.is_nothing() ? right.value : sum(Operator::Add, left, right, sign, whole);
}

Value Algebra::subtract(const Operand& left, const Operand& right, Span sign, Span whole) {
  return left.value.is_zero() ? negate(right, whole) : sum(Operator::Subtract, left, right, sign, whole);
}

Value Algebra::sum(Operator op, const Operand& left, const Operand& right, Span sign, Span whole) {
  if (left.value.is_nothing() || right.value.is_nothing()) {
    return {};
  }
  if (right.value.is_zero()) {
    return left.value;
  }
  if (left.value.size() != right.value.size()) {
    context_.report.report(Finding::SizesDiffer, sign, graph::row(op).spelling, describe(left.value),
                           describe(right.value));
    return {};
  }
  return each(left.value.size(), [&](std::size_t i) { return compute(op, {left.value[i], right.value[i]}, whole); });
}

/// A known factor of 0 says that the scene does not need the other, as 0 in a vector of directions does.
std::optional<Scalar> Algebra::product(const Scalar& a, const Scalar& b, Span whole) {
  return a.is_zero() || b.is_zero() ? Scalar{} : compute(Operator::Multiply, {a, b}, whole);
}

Value Algebra::multiply(const Operand& left, const Operand& right, Span sign, Span whole) {
  const Value& a = left.value;
  const Value& b = right.value;
  if (a.is_vector() && b.is_vector()) {
    context_.report.report(Finding::VectorProduct, sign);
  }
  if (a.is_scalar()) {
    return each(b.size(), [&](std::size_t i) { return product(a[0], b[i], whole); });
  }
  if (b.is_scalar()) {
    return each(a.size(), [&](std::size_t i) { return product(a[i], b[0], whole); });
  }
  return {};
}

Value Algebra::divide(const Operand& left, const Operand& right, Span whole) {
  if (!expect_number(right, "a divisor")) {
    return {};
  }
  if (right.value.is_zero()) {
    context_.report.report(Finding::DivisionByZero, right.span, context_.sources.text(right.span));
    return {};
  }
  return each(left.value.size(), [&](std::size_t i) {
    return compute(Operator::Divide, {left.value[i], right.value[0]}, whole);
  });
}

Value Algebra::power(const Operand& base, const Operand& exponent, Span whole) {
  const bool base_fits = expect_number(base, "the base of a power");
  if (!expect_number(exponent, "an exponent") || !base_fits) {
    return {};
  }
  const Scalar& power = exponent.value[0];
  const Scalar& root = base.value[0];
  if (power.is_number() && power.number == 2 && root.node) {
    const auto square = squares_of_norms_.find(index(*root.node));
    if (square != squares_of_norms_.end()) {
      return square->second;
    }
  }
  if (root.is_zero() && power.is_number() && power.number < 0) {
    context_.report.report(Finding::DivisionByZero, base.span, context_.sources.text(base.span));
    return {};
  }
  return each(1, [&](std::size_t) { return compute(Operator::Power, {root, power}, whole); });
}

Value Algebra::choose(Scalar condition, const Operand& yes, const Operand& no, Span whole) {
  if (yes.value.is_nothing() || no.value.is_nothing()) {
    return {};
  }
  const bool fits = yes.value.size() == no.value.size() || yes.value.is_zero() || no.value.is_zero();
  if (!fits) {
    context_.report.report(Finding::SizesDiffer, whole, "if", describe(yes.value), describe(no.value));
    return {};
  }
  const auto component = [](const Value& value, std::size_t i) { return value.is_zero() ? Scalar{} : value[i]; };
  return each(std::max(yes.value.size(), no.value.size()), [&](std::size_t i) {
    return compute(Operator::If, {condition, component(yes.value, i), component(no.value, i)}, whole);
  });
}

Value Algebra::apply(Operator op, std::initializer_list<Operand> operands, std::string_view what, Span whole) {
  bool fits = true;
  for (const Operand& operand : operands) {
    fits = expect_number(operand, what) && fits;
  }
  if (!fits) {
    return {};
  }
  const Operand* first = operands.begin();
  return each(1, [&](std::size_t) {
    return operands.size() == 1 ? compute(op, {first[0].value[0]}, whole)
                                : compute(op, {first[0].value[0], first[1].value[0]}, whole);
  });
}

Value Algebra::rate(const Value& value, Span whole) {
  return each(value.size(),
              [&](std::size_t i) -> std::optional<Scalar> { return context_.arena.rate(value[i], whole); });
}

}  // namespace mbcc::model
