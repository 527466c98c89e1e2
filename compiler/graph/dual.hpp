#pragma once
// Forward-mode differentiation in any algebra T: a value and its derivative in one direction. Over Expr the
// derivatives are graph; nested, Dual<Dual<T>> carries the second derivative.

#include "graph/evaluate.hpp"

namespace mbcc::graph {

template <class T>
struct Dual {
  T value;
  T derivative;
};

template <class T>
Dual<T> number(const Dual<T>& like, double x) {
  return {number(like.value, x), number(like.value, 0)};
}
template <class T>
bool is_zero(const Dual<T>& x) {
  return is_zero(x.value) && is_zero(x.derivative);
}

/// The chain rule. A term whose inner derivative is zero is not formed: the derivative of x^c never meets ln x.
template <class T>
Dual<T> chain(Operator op, const T& value, const std::array<const Dual<T>*, 3>& operands) {
  if (op == Operator::If) {
    return {value, select(operands[0]->value, operands[1]->derivative, operands[2]->derivative)};
  }
  std::array<const T*, 3> values{};
  for (std::size_t i = 0; i < operands.size() && operands[i] != nullptr; ++i) {
    values[i] = &operands[i]->value;
  }
  T derivative = number(value, 0);
  for (std::size_t i = 0; i < operands.size() && operands[i] != nullptr; ++i) {
    const T& inner = operands[i]->derivative;
    if (!is_zero(inner)) {
      derivative = add(derivative, multiply(slope(op, i, value, values), inner));
    }
  }
  return {value, derivative};
}

#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a)     \
  template <class T>                                                            \
  Dual<T> function(const Dual<T>& a) {                                          \
    MBCC_USING_ELEMENTARY_FUNCTIONS;                                            \
    return chain<T>(Operator::name, function(a.value), {&a, nullptr, nullptr}); \
  }
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  template <class T>                                                                 \
  Dual<T> function(const Dual<T>& a, const Dual<T>& b) {                             \
    MBCC_USING_ELEMENTARY_FUNCTIONS;                                                 \
    return chain<T>(Operator::name, function(a.value, b.value), {&a, &b, nullptr});  \
  }
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  template <class T>                                                                          \
  Dual<T> function(const Dual<T>& a, const Dual<T>& b, const Dual<T>& c) {                    \
    return chain<T>(Operator::name, function(a.value, b.value, c.value), {&a, &b, &c});       \
  }
#include "graph/operators.def"

// clang-format off
template <class T> Dual<T> operator+(const Dual<T>& a, const Dual<T>& b) { return add(a, b); }
template <class T> Dual<T> operator-(const Dual<T>& a, const Dual<T>& b) { return subtract(a, b); }
template <class T> Dual<T> operator*(const Dual<T>& a, const Dual<T>& b) { return multiply(a, b); }
template <class T> Dual<T> operator/(const Dual<T>& a, const Dual<T>& b) { return divide(a, b); }
template <class T> Dual<T> operator-(const Dual<T>& a) { return negate(a); }
// clang-format on

}  // namespace mbcc::graph
