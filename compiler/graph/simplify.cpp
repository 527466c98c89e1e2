// Note [folding]: what Graph::apply does to an expression beyond making it exist once.
//
// * Constants fold when the result is finite; 1/0 stays and is reported where it is evaluated.
// * Numeric factors move to the front and merge: (2 x)(3 y) = 6 (x y), 2 x + 2 y = 2 (x + y), x + x = 2 x,
//   x / 4 = 0.25 x; not where the merged factor would overflow or vanish.
//   This may change the last digit of a result (as any other way of writing it would), and lets A, b and the
//   constraint itself share x y, x + y and so on.
// * x + 0, x - 0, 1 x, x / 1, x^1, -(-x), x - x = 0, 0 x = 0, x^0 = 1. The last three lose an infinity or a NaN that x
// may be:
//   a factor of zero says that the scene does not need x.
// * x x = x^2, so that squares exist once however they are written; (-x)^2 = x^2. (Program turns integer powers
//   into multiplications.)
// * Sums and products are ordered by node, constants first, so that a + b is b + a; where b - a exists, a - b is -(b -
// a). Nothing is
//   reassociated.
// * sin^2 x + cos^2 x = 1: directions that turn with time or with an angle stay of length 1. Loses the NaN of an
//   infinite x, which the constraint itself still has.
// * `if` of a constant condition, or with equal sides, is its side.

#include <algorithm>
#include <cmath>

#include "graph/evaluate.hpp"
#include "graph/graph.hpp"

namespace mbcc::graph {

namespace {

/// x as factor * rest, with a constant factor; rest is 1 for constants.
struct Scaled {
  double factor;
  Expr rest;
};

Expr operand(Expr x, std::size_t i) { return x.graph().at(x.node().operands[i]); }

bool is(Expr x, Operator op) { return x.node().kind == Kind::Apply && x.node().op == op; }

bool is_integer(double x) { return std::floor(x) == x && std::abs(x) < 1e9; }

Scaled split(Expr x) {
  if (x.is_constant()) {
    return {x.node().value, number(x, 1)};
  }
  if (is(x, Operator::Negate)) {
    return {-1, operand(x, 0)};
  }
  if (is(x, Operator::Multiply) && operand(x, 0).is_constant()) {
    return {operand(x, 0).node().value, operand(x, 1)};
  }
  return {1, x};
}

/// Constants first, then in the order of making.
Expr ordered(Operator op, Expr a, Expr b) {
  const bool swap = a.is_constant() == b.is_constant() ? b < a : b.is_constant();
  return a.graph().intern(op, swap ? std::array{b, a} : std::array{a, b});
}

/// factor * rest, where rest has no numeric factor of its own.
Expr scale(double factor, Expr rest) {
  Graph& graph = rest.graph();
  if (factor == 0 || rest.is_constant(1)) {
    return graph.constant(factor == 0 ? 0 : factor);
  }
  if (factor == 1) {
    return rest;
  }
  if (factor == -1) {
    return graph.intern(Operator::Negate, std::array{rest});
  }
  return graph.intern(Operator::Multiply, std::array{graph.constant(factor), rest});
}

/// factor * x for any x.
Expr times(double factor, Expr x) {
  const Scaled scaled = split(x);
  const double product = factor * scaled.factor;
  return product == 0 || !std::isfinite(product) ? scale(factor, x) : scale(product, scaled.rest);
}

Expr fold_sum(Expr a, Expr b);

Expr fold_difference(Expr a, Expr b) {
  if (is_zero(b)) {
    return a;
  }
  const Scaled left = split(a);
  const Scaled right = split(b);
  if (left.rest == right.rest && std::isfinite(left.factor - right.factor)) {
    return scale(left.factor - right.factor, left.rest);
  }
  if (is_zero(a)) {
    return scale(-right.factor, right.rest);
  }
  if (right.factor < 0) {
    return fold_sum(a, scale(-right.factor, right.rest));
  }
  if (left.factor < 0) {
    const Expr sum = fold_sum(scale(-left.factor, left.rest), b);
    return times(-1, sum);
  }
  if (left.factor == right.factor && left.factor != 1 && !a.is_constant() && !b.is_constant()) {
    return times(left.factor, fold_difference(left.rest, right.rest));
  }
  if (a.graph().contains(Operator::Subtract, std::array{b, a})) {
    return scale(-1, a.graph().intern(Operator::Subtract, std::array{b, a}));
  }
  return a.graph().intern(Operator::Subtract, std::array{a, b});
}

/// Whether a and b are the squares of sine and cosine of one argument.
bool are_squares_of_one_angle(Expr a, Expr b) {
  const auto squared = [](Expr x) { return is(x, Operator::Power) && operand(x, 1).is_constant(2); };
  if (!squared(a) || !squared(b)) {
    return false;
  }
  const Expr first = operand(a, 0);
  const Expr second = operand(b, 0);
  return ((is(first, Operator::Sin) && is(second, Operator::Cos)) ||
          (is(first, Operator::Cos) && is(second, Operator::Sin))) &&
         operand(first, 0) == operand(second, 0);
}

Expr fold_sum(Expr a, Expr b) {
  if (is_zero(a) || is_zero(b)) {
    return is_zero(a) ? b : a;
  }
  if (are_squares_of_one_angle(a, b)) {
    return number(a, 1);
  }
  const Scaled left = split(a);
  const Scaled right = split(b);
  if (left.rest == right.rest && std::isfinite(left.factor + right.factor)) {
    return scale(left.factor + right.factor, left.rest);
  }
  if (left.factor < 0 && right.factor < 0) {
    return times(-1, sum_of({scale(-left.factor, left.rest), scale(-right.factor, right.rest)}));
  }
  if (right.factor < 0) {
    return fold_difference(a, scale(-right.factor, right.rest));
  }
  if (left.factor < 0) {
    return fold_difference(b, scale(-left.factor, left.rest));
  }
  if (left.factor == right.factor && left.factor != 1 && !a.is_constant() && !b.is_constant()) {
    return times(left.factor, fold_sum(left.rest, right.rest));
  }
  return ordered(Operator::Add, a, b);
}

Expr fold_power(Expr a, Expr b);

Expr fold_product(Expr a, Expr b) {
  const Scaled left = split(a);
  const Scaled right = split(b);
  const double factor = left.factor * right.factor;
  if (factor == 0 || !std::isfinite(factor)) {
    return factor == 0 && (left.factor == 0 || right.factor == 0) ? number(a, 0) : ordered(Operator::Multiply, a, b);
  }
  if (left.rest.is_constant(1) || right.rest.is_constant(1)) {
    return scale(factor, left.rest.is_constant(1) ? right.rest : left.rest);
  }
  if (left.rest == right.rest) {
    return times(factor, fold_power(left.rest, number(a, 2)));
  }
  return scale(factor, ordered(Operator::Multiply, left.rest, right.rest));
}

Expr fold_quotient(Expr a, Expr b) {
  Graph& graph = a.graph();
  const Scaled left = split(a);
  const Scaled right = split(b);
  if (left.factor == 0 && right.factor != 0) {
    return number(a, 0);
  }
  const double factor = left.factor / right.factor;
  if (factor == 0 || !std::isfinite(factor)) {
    return graph.intern(Operator::Divide, std::array{a, b});
  }
  if (right.rest.is_constant(1)) {
    return scale(factor, left.rest);
  }
  if (left.rest == right.rest) {
    return graph.constant(factor);
  }
  if (left.rest.is_constant(1)) {
    return graph.intern(Operator::Divide, std::array{graph.constant(factor), right.rest});
  }
  return scale(factor, graph.intern(Operator::Divide, std::array{left.rest, right.rest}));
}

Expr fold_power(Expr a, Expr b) {
  Graph& graph = a.graph();
  if (is_zero(b)) {
    return number(a, 1);
  }
  if (b.is_constant(1) || a.is_constant(1)) {
    return a;
  }
  const Scaled base = split(a);
  if (b.is_constant() && is_integer(b.node().value) && base.factor != 1) {
    const double factor = std::pow(base.factor, b.node().value);
    if (std::isfinite(factor) && factor != 0) {
      return scale(factor, graph.intern(Operator::Power, std::array{base.rest, b}));
    }
  }
  return graph.intern(Operator::Power, std::array{a, b});
}

}  // namespace

double numeric_factor(Expr x) { return split(x).factor; }

Expr Graph::apply(Operator op, std::span<const Expr> operands) {
  if (std::all_of(operands.begin(), operands.end(), [](Expr x) { return x.is_constant(); })) {
    std::array<const double*, 3> values{};
    for (std::size_t i = 0; i < operands.size(); ++i) {
      values[i] = &nodes_[operands[i].id()].value;
    }
    const double value = perform(op, values);
    if (std::isfinite(value)) {
      return constant(value == 0 ? 0 : value);
    }
    return intern(op, operands);
  }
  switch (op) {
    case Operator::Add:
      return fold_sum(operands[0], operands[1]);
    case Operator::Subtract:
      return fold_difference(operands[0], operands[1]);
    case Operator::Multiply:
      return fold_product(operands[0], operands[1]);
    case Operator::Divide:
      return fold_quotient(operands[0], operands[1]);
    case Operator::Negate:
      return fold_difference(constant(0), operands[0]);
    case Operator::Power:
      return fold_power(operands[0], operands[1]);
    case Operator::If:
      if (operands[0].is_constant() || operands[1] == operands[2]) {
        return operands[0].is_constant(0) ? operands[2] : operands[1];
      }
      return intern(op, operands);
    default:
      return intern(op, operands);
  }
}

}  // namespace mbcc::graph
