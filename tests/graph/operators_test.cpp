// Every row of the operator table: its value, its first and its second derivatives, in every algebra.

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <vector>

#include "graph/feed.hpp"
#include "support/quad.hpp"
#include "support/random.hpp"
#include "support/tracked.hpp"

namespace mbcc::graph {
namespace {

using test::Quad;
using test::Random;
using test::Tracked;

/// Applies `op` to as many operands as it takes.
template <class T>
T perform_on(Operator op, const std::vector<T>& operands) {
  std::array<const T*, 3> pointers{};
  for (std::size_t i = 0; i < operands.size(); ++i) {
    pointers[i] = &operands[i];
  }
  return perform(op, pointers);
}

struct Known {
  std::vector<double> operands;
  double value;
};

/// Values that anybody can check, at least one per row.
std::multimap<Operator, Known> known_values() {
  const double pi = std::acos(-1.0);
  const double e = std::exp(1.0);
  return {
      {Operator::Add, {{2, 3}, 5}},
      {Operator::Subtract, {{2, 3}, -1}},
      {Operator::Multiply, {{2, 3}, 6}},
      {Operator::Divide, {{3, 2}, 1.5}},
      {Operator::Negate, {{2}, -2}},
      {Operator::Power, {{2, 3}, 8}},
      {Operator::Power, {{4, -0.5}, 0.5}},
      {Operator::Power, {{-2, 3}, -8}},
      {Operator::Power, {{0, 0}, 1}},
      {Operator::Sin, {{pi / 6}, 0.5}},
      {Operator::Cos, {{pi / 3}, 0.5}},
      {Operator::Tan, {{pi / 4}, 1}},
      {Operator::Asin, {{0.5}, pi / 6}},
      {Operator::Acos, {{0.5}, pi / 3}},
      {Operator::Atan, {{1}, pi / 4}},
      {Operator::Exp, {{1}, e}},
      {Operator::Ln, {{e}, 1}},
      {Operator::Log, {{1000}, 3}},
      {Operator::Sinh, {{std::log(2)}, 0.75}},
      {Operator::Cosh, {{std::log(2)}, 1.25}},
      {Operator::Tanh, {{std::log(2)}, 0.6}},
      {Operator::Asinh, {{0.75}, std::log(2)}},
      {Operator::Acosh, {{1.25}, std::log(2)}},
      {Operator::Atanh, {{0.6}, std::log(2)}},
      {Operator::Sqrt, {{9}, 3}},
      {Operator::Abs, {{-3}, 3}},
      {Operator::Sign, {{-3}, -1}},
      {Operator::Sign, {{3}, 1}},
      {Operator::Sign, {{0}, 0}},
      {Operator::Min, {{2, 3}, 2}},
      {Operator::Min, {{3, 2}, 2}},
      {Operator::Max, {{2, 3}, 3}},
      {Operator::Max, {{3, 2}, 3}},
      {Operator::Atan2, {{1, -1}, 3 * pi / 4}},
      {Operator::Hypot, {{3, -4}, 5}},
      {Operator::Less, {{2, 3}, 1}},
      {Operator::Less, {{3, 3}, 0}},
      {Operator::LessEqual, {{3, 3}, 1}},
      {Operator::LessEqual, {{3, 2}, 0}},
      {Operator::Equal, {{3, 3}, 1}},
      {Operator::Equal, {{3, 2}, 0}},
      {Operator::If, {{1, 2, 3}, 2}},
      {Operator::If, {{0, 2, 3}, 3}},
  };
}

/// A point at which `op` is smooth, not within 0.1 of where it is not.
std::vector<double> smooth_point(Operator op, Random& random) {
  const auto both_signs = [&](double low, double high) {
    return random.uniform(low, high) * (random.chance(0.5) ? 1 : -1);
  };
  switch (op) {
    case Operator::Power:
      return {random.uniform(0.1, 3), random.uniform(-3, 3)};
    case Operator::Divide:
      return {random.uniform(-3, 3), both_signs(0.1, 3)};
    case Operator::Ln:
    case Operator::Log:
    case Operator::Sqrt:
      return {random.uniform(0.1, 3)};
    case Operator::Asin:
    case Operator::Acos:
    case Operator::Atanh:
      return {random.uniform(-0.9, 0.9)};
    case Operator::Acosh:
      return {random.uniform(1.1, 4)};
    case Operator::Tan:
      return {random.uniform(-1.4, 1.4)};
    case Operator::Abs:
    case Operator::Sign:
      return {both_signs(0.1, 3)};
    case Operator::Min:
    case Operator::Max:
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Equal: {
      const double a = random.uniform(-3, 3);
      return {a, a + both_signs(0.1, 3)};
    }
    case Operator::If:
      return {random.chance(0.5) ? 1.0 : 0.0, random.uniform(-3, 3), random.uniform(-3, 3)};
    default: {
      std::vector<double> point(static_cast<std::size_t>(arity(op)));
      for (double& x : point) {
        x = both_signs(0.1, 3);
      }
      return point;
    }
  }
}

/// A direction that stays on the smooth side: a condition does not move.
std::vector<double> direction(Operator op, Random& random) {
  std::vector<double> along(static_cast<std::size_t>(arity(op)));
  for (double& x : along) {
    x = random.uniform(-1, 1);
  }
  if (op == Operator::If) {
    along[0] = 0;
  }
  return along;
}

/// First and second derivative of s -> op(x + s d) at 0 by central differences in quadruple precision. With h = 1e-6
/// the five-point formulas leave h^4 = 1e-24 times a fifth or sixth derivative, below 1e8 on smooth_point, and rounding
/// leaves 1e-34/h^2 = 1e-22: far below the rounding of a double.
struct Differences {
  double first, second;
};
Differences differences(Operator op, const std::vector<double>& x, const std::vector<double>& d) {
  const Quad h("1e-6");
  const auto at = [&](int steps) {
    std::vector<Quad> operands;
    for (std::size_t i = 0; i < x.size(); ++i) {
      operands.push_back(Quad(x[i]) + steps * h * Quad(d[i]));
    }
    return perform_on(op, operands);
  };
  const Quad first = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
  const Quad second = (16 * (at(1) + at(-1)) - (at(2) + at(-2)) - 30 * at(0)) / (12 * h * h);
  return {static_cast<double>(first), static_cast<double>(second)};
}

/// s -> op(x + s d) at 0, to second order, with error bounds.
Dual<Dual<Tracked>> along_line(Operator op, const std::vector<double>& x, const std::vector<double>& d) {
  std::vector<Dual<Dual<Tracked>>> operands;
  for (std::size_t i = 0; i < x.size(); ++i) {
    operands.push_back({{Tracked(x[i]), Tracked(d[i])}, {Tracked(d[i]), Tracked(0)}});
  }
  return perform_on(op, operands);
}

constexpr int points = 200;

}  // namespace

TEST_CASE("every operator computes what its name says") {
  const auto known = known_values();
  for (const OperatorRow& row : operator_table) {
    INFO(row.name);
    REQUIRE(known.count(row.op) > 0);
    for (auto [item, end] = known.equal_range(row.op); item != end; ++item) {
      CHECK(item->second.operands.size() == static_cast<std::size_t>(row.arity));
      // The known value is rounded, and so is the operand that stands for pi/6 or e.
      CHECK(perform_on(row.op, item->second.operands) == Approx(item->second.value).epsilon(1e-15).margin(0));
    }
  }
}

TEST_CASE("every operator has the value that quadruple precision gives") {
  Random random(1);
  for (const OperatorRow& row : operator_table) {
    for (int i = 0; i < points; ++i) {
      const std::vector<double> x = smooth_point(row.op, random);
      const std::vector<Quad> exact_x(x.begin(), x.end());
      const double exact = static_cast<double>(perform_on(row.op, exact_x));
      CAPTURE(row.name, x);
      CHECK(std::abs(perform_on(row.op, x) - exact) <= test::rounding(row.op) * std::abs(exact));
    }
  }
}

TEST_CASE("first and second derivatives of every operator are those of differences") {
  Random random(2);
  for (const OperatorRow& row : operator_table) {
    for (int i = 0; i < points; ++i) {
      const std::vector<double> x = smooth_point(row.op, random);
      const std::vector<double> d = direction(row.op, random);
      const Dual<Dual<Tracked>> dual = along_line(row.op, x, d);
      const Differences expected = differences(row.op, x, d);
      constexpr double of_the_differences = 1e-14;
      CAPTURE(row.name, x, d, dual.value.derivative.value, dual.derivative.derivative.value);
      CHECK(std::abs(dual.value.derivative.value - expected.first) <=
            4 * dual.value.derivative.error + of_the_differences);
      CHECK(dual.derivative.value.value == dual.value.derivative.value);
      CHECK(std::abs(dual.derivative.derivative.value - expected.second) <=
            4 * dual.derivative.derivative.error + of_the_differences);
      CHECK(dual.derivative.derivative.error < 1e-11 * std::max(1.0, std::abs(expected.second)));
    }
  }
}

TEST_CASE("the FEED form of every operator has the derivatives of nested duals in every direction") {
  Random random(3);
  for (const OperatorRow& row : operator_table) {
    for (int i = 0; i < points; ++i) {
      const std::vector<double> x = smooth_point(row.op, random);
      const std::vector<double> d = direction(row.op, random);
      std::vector<Feed> operands;
      for (std::size_t k = 0; k < x.size(); ++k) {
        operands.push_back(Feed::variable(x[k], k, x.size(), Feed::Order::Second));
      }
      const Feed feed = perform_on(row.op, operands);
      double first = 0, second = 0;
      for (std::size_t k = 0; k < x.size(); ++k) {
        first += feed.first(k) * d[k];
        for (std::size_t l = 0; l < x.size(); ++l) {
          second += feed.second(k, l) * d[k] * d[l];
        }
      }
      const Dual<Dual<Tracked>> dual = along_line(row.op, x, d);
      CAPTURE(row.name, x, d);
      CHECK(feed.value() == dual.value.value.value);
      CHECK(test::agree(dual.value.derivative, first));
      CHECK(test::agree(dual.derivative.derivative, second));
    }
  }
}

TEST_CASE("derivatives as graph have the values of derivatives in numbers") {
  Random random(4);
  for (const OperatorRow& row : operator_table) {
    Graph graph;
    std::vector<Dual<Dual<Expr>>> operands;
    const std::vector<double> d = direction(row.op, random);
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(row.arity); ++k) {
      const Expr x = graph.leaf(Kind::Coordinate, k);
      const Expr along = graph.constant(d[k]);
      operands.push_back({{x, along}, {along, graph.constant(0)}});
    }
    const Dual<Dual<Expr>> symbolic = perform_on(row.op, operands);
    for (int i = 0; i < points; ++i) {
      const std::vector<double> x = smooth_point(row.op, random);
      const auto leaf = [&](const Node& node) { return node.kind == Kind::Constant ? node.value : x[node.index]; };
      const std::vector<double> values = evaluate<double>(
          graph, std::array{symbolic.value.value, symbolic.value.derivative, symbolic.derivative.derivative}, leaf);
      const Dual<Dual<Tracked>> dual = along_line(row.op, x, d);
      CAPTURE(row.name, x, d);
      CHECK(values[0] == dual.value.value.value);
      CHECK(test::agree(dual.value.derivative, values[1]));
      CHECK(test::agree(dual.derivative.derivative, values[2]));
    }
  }
}

TEST_CASE("functions are found by their spelling, symbols are not") {
  for (const OperatorRow& row : operator_table) {
    const bool is_word = std::isalpha(static_cast<unsigned char>(row.spelling.front())) != 0;
    CHECK(find_function(row.spelling) == (is_word ? std::optional(row.op) : std::nullopt));
  }
  CHECK(find_function("sine") == std::nullopt);
}

}  // namespace mbcc::graph
