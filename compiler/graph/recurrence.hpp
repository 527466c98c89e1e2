#pragma once
// Note [recurrences]: Taylor coefficients along a motion, one order after the other. Where the values and the
// coefficients below order m of all nodes are known, and those of order m of the leaves, `recur` gives v_m of each
// node, operands first. It is written once, for any algebra: over double it is the oracle (series.hpp), over Expr it
// makes the code that computes the coefficients (program/expansion.hpp).
//
// Every rule splits its convolution the same way: the two terms that hold coefficients of order m are written out,
//   (a b)_m = a_m b_0 + a_0 b_m + sum of a_j b_(m-j) over 0 < j < m,
// so that v_m is linear in what is new, and what remains are sums over older coefficients alone. Those of all nodes can
// be computed together, before anything of order m is known.
//
// A node rests if its value does not change along the motion until a switch changes its side; told here of steps and of
// what is made of steps at once, which is what slopes are.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "graph/evaluate.hpp"

namespace mbcc::graph {

inline bool rests(const Graph& graph, NodeId id) {
  const auto is_step = [&graph](NodeId at) {
    const Node& node = graph[at];
    return node.level <= Level::Parameter ||
           (node.kind == Kind::Apply && (node.op == Operator::Sign || node.op == Operator::Less ||
                                         node.op == Operator::LessEqual || node.op == Operator::Equal));
  };
  const std::span<const NodeId> operands = graph[id].used_operands();
  return is_step(id) || (!operands.empty() && std::all_of(operands.begin(), operands.end(), is_step));
}
inline bool rests(Expr x) { return rests(x.graph(), x.id()); }

/// The coefficient of order m of the values of applications. `Terms` knows the rest, for any expression:
///   Number                     the algebra
///   value(x), coefficient(x)   x_0 and x_m
///   products(a, b)             sum of a_j b_(m-j), 0 < j < m
///   weighted(a, b)             sum of j a_j b_(m-j), 0 < j < m
///   squares(a)                 products(a, a)
///   inverse_order()            1 / m
/// Slopes are expressions, which are added to the graph.
template <class Terms>
class Recurrences {
 public:
  using T = typename Terms::Number;

  explicit Recurrences(Terms& terms) : terms_(terms) {}

  T operator()(Expr v) {
    switch (row(v.node().op).recurrence) {
      case Recurrence::Linear:
        return linear(v);
      case Recurrence::Product:
        return product(operand(v, 0), operand(v, 1));
      case Recurrence::Quotient:
        return quotient(v, operand(v, 0), operand(v, 1));
      case Recurrence::Root:
        return root(v, operand(v, 0));
      case Recurrence::Power:
        return power(v, operand(v, 0), operand(v, 1));
      case Recurrence::Slopes:
        return slopes(v);
      case Recurrence::Switch:
        return switched(v);
    }
    return zero(v);
  }

 private:
  static Expr operand(Expr v, std::size_t i) { return v.graph().at(v.node().operands[i]); }
  static bool is(Expr v, Operator op) { return v.node().kind == Kind::Apply && v.node().op == op; }

  T value(Expr x) { return terms_.value(x); }
  T coefficient(Expr x) { return terms_.coefficient(x); }
  T zero(Expr like) { return number(value(like), 0); }

  T linear(Expr v) {
    const std::size_t count = v.node().used_operands().size();
    const T a = coefficient(operand(v, 0));
    const T b = count > 1 ? coefficient(operand(v, 1)) : a;
    return perform<T>(v.node().op, {&a, &b, nullptr});
  }

  T product(Expr a, Expr b) {
    if (rests(a)) {
      return rests(b) ? zero(a) : value(a) * coefficient(b);
    }
    if (rests(b)) {
      return coefficient(a) * value(b);
    }
    if (a == b) {
      return sum_of({number(value(a), 2) * (value(a) * coefficient(a)), terms_.squares(a)});
    }
    const T newest = sum_of({coefficient(a) * value(b), value(a) * coefficient(b)});
    return newest + terms_.products(a, b);
  }

  T quotient(Expr v, Expr a, Expr b) {
    if (rests(b)) {
      return coefficient(a) / value(b);
    }
    if (const auto [base, exponent] = as_power(b); !is_zero(exponent)) {
      // a / s^p = a s^-p: one convolution less than s^p and the quotient, and shared by all quotients by s^p.
      return a.is_constant() ? power_of(v, base, -exponent) : product(a, number(a, 1) / b);
    }
    const T remaining = sum_of({value(v) * coefficient(b), terms_.products(b, v)});
    return (rests(a) ? -remaining : coefficient(a) - remaining) / value(b);
  }

  T root(Expr v, Expr a) { return quotient_of({coefficient(a) - terms_.squares(v), number(value(v), 2) * value(v)}); }

  struct BaseAndExponent {
    Expr base;
    Expr exponent;  ///< 0 if the expression is no power
  };

  /// sqrt(x)^n is x^(n/2).
  static BaseAndExponent as_power(Expr x) {
    if (is(x, Operator::Sqrt)) {
      return {operand(x, 0), number(x, 0.5)};
    }
    if (!is(x, Operator::Power) || !rests(operand(x, 1))) {
      return {x, number(x, 0)};
    }
    const Expr base = operand(x, 0);
    return is(base, Operator::Sqrt) ? BaseAndExponent{operand(base, 0), number(x, 0.5) * operand(x, 1)}
                                    : BaseAndExponent{base, operand(x, 1)};
  }

  T power(Expr v, Expr a, Expr b) {
    if (rests(a) && rests(b)) {
      return zero(v);
    }
    if (!rests(b)) {
      return slope_term(b * log(a), v);
    }
    // Positive integer exponents are products: the recurrence of powers divides by a_0, which may be zero.
    if (const double n = b.is_constant() ? b.node().value : 0;
        n >= 2 && n <= largest_multiplied_exponent && n == std::floor(n)) {
      const bool is_even = std::fmod(n, 2) == 0;
      return is_even ? product(pow(a, number(a, n / 2)), pow(a, number(a, n / 2)))
                     : product(pow(a, number(a, n - 1)), a);
    }
    const auto [base, exponent] = as_power(v);
    return power_of(v, base, exponent);
  }

  /// Of v = constant base^p: m a_0 v_m = p m a_m v_0 + sum of ((p + 1) j - m) a_j v_(m-j).
  T power_of(Expr v, Expr base, Expr p) {
    const T weighted =
        product_of({(value(p) + number(value(p), 1)) * terms_.inverse_order(), terms_.weighted(base, v)});
    return sum_of({value(p) * value(v) * coefficient(base), weighted - terms_.products(base, v)}) / value(base);
  }

  T slopes(Expr v) {
    std::array<Expr, 3> operands;
    std::array<const Expr*, 3> pointers{};
    const std::size_t count = v.node().used_operands().size();
    for (std::size_t i = 0; i < count; ++i) {
      operands[i] = operand(v, i);
      pointers[i] = &operands[i];
    }
    T sum = zero(v);
    for (std::size_t i = 0; i < count; ++i) {
      if (!rests(operands[i])) {
        sum = sum + slope_term(operands[i], slope(v.node().op, i, v, pointers));
      }
    }
    return sum;
  }

  /// The part of v_m that comes from v' = slope a'.
  T slope_term(Expr a, Expr slope) {
    const T newest = value(slope) * coefficient(a);
    return rests(slope) ? newest : newest + product_of({terms_.inverse_order(), terms_.weighted(a, slope)});
  }

  T switched(Expr v) {
    if (rests(v)) {
      return zero(v);
    }
    if (is(v, Operator::If)) {
      const T chosen = coefficient(operand(v, 1));
      return select(value(operand(v, 0)), chosen, coefficient(operand(v, 2)));
    }
    return slopes(v);  // which rest
  }

  Terms& terms_;
};

}  // namespace mbcc::graph
