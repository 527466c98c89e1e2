#pragma once
// A double that carries a bound of its own rounding error, to first order: what tests compare against, instead of
// guessed tolerances. It is an algebra for graph::evaluate, alone and in duals.

#include <array>
#include <cmath>
#include <limits>

#include "graph/dual.hpp"

namespace mbcc::test {

struct Tracked {
  Tracked() = default;
  explicit Tracked(double x) : value(x) {}

  double value = 0;
  double error = 0;

  friend bool operator==(const Tracked& a, const Tracked& b) { return a.value == b.value && a.error + b.error == 0; }
};

/// What `op` adds to the errors of its operands, relative to the result: half an ulp for arithmetic, and what the
/// functions of glibc admit to, at most two ulps, for the rest.
inline double rounding(graph::Operator op) {
  switch (op) {
    case graph::Operator::Add:
    case graph::Operator::Subtract:
    case graph::Operator::Multiply:
    case graph::Operator::Divide:
    case graph::Operator::Sqrt:
      return std::numeric_limits<double>::epsilon() / 2;
    default:
      return 2 * std::numeric_limits<double>::epsilon();
  }
}

/// Whether rounding may have decided the outcome of `op`, which jumps.
inline bool is_undecided(graph::Operator op, const Tracked& a, const Tracked& b) {
  switch (op) {
    case graph::Operator::Sign:
      return a.error > 0 && std::abs(a.value) <= a.error;
    case graph::Operator::Less:
    case graph::Operator::LessEqual:
    case graph::Operator::Equal:
      return a.error + b.error > 0 && std::abs(a.value - b.value) <= a.error + b.error;
    default:
      return false;
  }
}

inline Tracked track(graph::Operator op, const std::array<const Tracked*, 3>& operands) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (op == graph::Operator::If) {
    Tracked side = operands[0]->value != 0 ? *operands[1] : *operands[2];
    side.error = operands[0]->error > 0 ? unknown : side.error;
    return side;
  }
  std::array<const double*, 3> values{};
  for (std::size_t i = 0; i < operands.size() && operands[i] != nullptr; ++i) {
    values[i] = &operands[i]->value;
  }
  Tracked result(graph::perform(op, values));
  if (is_undecided(op, *operands[0], operands[1] == nullptr ? *operands[0] : *operands[1])) {
    result.error = unknown;
    return result;
  }
  result.error = rounding(op) * std::abs(result.value);
  for (std::size_t i = 0; i < operands.size() && operands[i] != nullptr; ++i) {
    if (operands[i]->error > 0) {
      result.error += std::abs(graph::slope(op, i, result.value, values)) * operands[i]->error;
    }
  }
  return result;
}

#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  inline Tracked function(const Tracked& a) { return track(graph::Operator::name, {&a, nullptr, nullptr}); }
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  inline Tracked function(const Tracked& a, const Tracked& b) {                      \
    return track(graph::Operator::name, {&a, &b, nullptr});                          \
  }
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  inline Tracked function(const Tracked& a, const Tracked& b, const Tracked& c) {             \
    return track(graph::Operator::name, {&a, &b, &c});                                        \
  }
#include "graph/operators.def"

// clang-format off
inline Tracked operator+(const Tracked& a, const Tracked& b) { return add(a, b); }
inline Tracked operator-(const Tracked& a, const Tracked& b) { return subtract(a, b); }
inline Tracked operator*(const Tracked& a, const Tracked& b) { return multiply(a, b); }
inline Tracked operator/(const Tracked& a, const Tracked& b) { return divide(a, b); }
inline Tracked operator-(const Tracked& a) { return negate(a); }
// clang-format on

/// Whether two values, computed in different orders, can be the same: the orders may double a bound to first order,
/// and each of the two has one.
inline bool agree(const Tracked& a, double b) { return std::abs(a.value - b) <= 4 * a.error; }

/// Whether a value is known well enough for a comparison to mean something.
inline bool is_sharp(const Tracked& a) {
  return std::isfinite(a.value) && a.error <= 1e-9 * std::max(1.0, std::abs(a.value));
}

}  // namespace mbcc::test
