// Where functions end or jump: what the language promises there, in numbers, in duals, and in the FEED form.

#include <catch2/catch.hpp>
#include <cmath>

#include "graph/feed.hpp"

namespace mbcc::graph {
namespace {

using Second = Dual<Dual<double>>;

/// f and its derivatives along x at one point, by nested duals over numbers.
template <class Function>
Second at(double x, const Function& f) {
  return f(Second{{x, 1}, {1, 0}});
}

/// The same through the graph and through FEED.
struct Along {
  double value, first, second;
  bool operator==(const Along&) const = default;
};
template <class Function>
Along through_graph(double x, const Function& f) {
  Graph graph;
  const Expr leaf = graph.leaf(Kind::Coordinate, 0);
  const Expr one = graph.constant(1);
  const Dual<Dual<Expr>> dual = f(Dual<Dual<Expr>>{{leaf, one}, {one, graph.constant(0)}});
  const auto numbers =
      evaluate<double>(graph, std::array{dual.value.value, dual.value.derivative, dual.derivative.derivative},
                       [&](const Node& node) { return node.kind == Kind::Constant ? node.value : x; });
  return {numbers[0], numbers[1], numbers[2]};
}
template <class Function>
Along through_feed(double x, const Function& f) {
  const Feed feed = f(Feed::variable(x, 0, 1, Feed::Order::Second));
  return {feed.value(), feed.first(0), feed.second(0, 0)};
}
template <class Function>
void check_everywhere(double x, const Function& f, const Along& expected) {
  const Second dual = at(x, f);
  CHECK(Along{dual.value.value, dual.value.derivative, dual.derivative.derivative} == expected);
  CHECK(through_graph(x, f) == expected);
  CHECK(through_feed(x, f) == expected);
}

/// The constant c in the algebra of x.
template <class T>
T like(const T& x, double c) {
  return number(x, c);
}
Feed like(const Feed& x, double c) { return Feed::constant(c, x.variables(), Feed::Order::Second); }

}  // namespace

TEST_CASE("a constant power never meets the logarithm of its base") {
  const auto power = [](double c) { return [c](const auto& x) { return pow(x, like(x, c)); }; };
  check_everywhere(0, power(2), {0, 0, 2});
  check_everywhere(0, power(3), {0, 0, 0});
  check_everywhere(0, power(1), {0, 1, 0});
  check_everywhere(0, power(0), {1, 0, 0});
  check_everywhere(-2, power(2), {4, -4, 2});
  check_everywhere(-2, power(3), {-8, 12, -12});
  check_everywhere(-2, power(-1), {-0.5, -0.25, -0.25});
}

TEST_CASE("an exponent that a run sets has the derivatives of that constant, at zero, too") {
  Graph graph;
  const Expr x = graph.leaf(Kind::Coordinate, 0), p = graph.leaf(Kind::Parameter, 0);
  const Expr zero = graph.constant(0), one = graph.constant(1);
  const Dual<Dual<Expr>> power =
      pow(Dual<Dual<Expr>>{{x, one}, {one, zero}}, Dual<Dual<Expr>>{{p, zero}, {zero, zero}});
  const std::array roots = {power.value.value, power.value.derivative, power.derivative.derivative};
  const auto at_zero = [&](double exponent) {
    const auto values = evaluate<double>(graph, roots, [&](const Node& node) {
      return node.kind == Kind::Constant ? node.value : node.kind == Kind::Parameter ? exponent : 0;
    });
    return Along{values[0], values[1], values[2]};
  };
  CHECK(at_zero(0) == Along{1, 0, 0});
  CHECK(at_zero(1) == Along{0, 1, 0});
  CHECK(at_zero(2) == Along{0, 0, 2});
  CHECK(at_zero(3) == Along{0, 0, 0});
  CHECK(std::isinf(at_zero(1.5).second));  // as it is
}

TEST_CASE("`if` lets nothing of the other side through") {
  const auto guarded = [](const auto& x) {
    return select(less(x, like(x, 1)), multiply(x, x), log(subtract(x, like(x, 1))));
  };
  check_everywhere(0.5, guarded, {0.25, 1, 2});
  const auto other = [](const auto& x) { return select(less(like(x, 1), x), sqrt(subtract(x, like(x, 1))), x); };
  check_everywhere(0.5, other, {0.5, 1, 0});
}

TEST_CASE("sign is zero at zero, and jumps have the slope of the side that they evaluate") {
  const auto sign_of = [](const auto& x) { return sign(x); };
  check_everywhere(0, sign_of, {0, 0, 0});
  check_everywhere(-0.0, sign_of, {0, 0, 0});
  check_everywhere(3, sign_of, {1, 0, 0});
  check_everywhere(0, [](const auto& x) { return abs(x); }, {0, 0, 0});
  const auto larger = [](const auto& x) { return maximum(multiply(x, x), x); };
  check_everywhere(2, larger, {4, 4, 2});
  check_everywhere(0.5, larger, {0.5, 1, 0});
  check_everywhere(1, larger, {1, 2, 2});  // equal: the left one
}

TEST_CASE("a NaN passes through") {
  const double nan = std::nan("");
  CHECK(std::isnan(sign(nan)));
  CHECK(std::isnan(minimum(nan, 1.0)));
  CHECK(std::isnan(minimum(1.0, nan)));
  CHECK(std::isnan(maximum(nan, 1.0)));
  CHECK(std::isnan(maximum(1.0, nan)));
}

}  // namespace mbcc::graph
