// Random expressions of all operators: the same derivatives by every way, and the same values however they are folded.

#include <catch2/catch.hpp>
#include <vector>

#include "graph/feed.hpp"
#include "graph/print.hpp"
#include "support/quad.hpp"
#include "support/random_expression.hpp"
#include "support/tracked.hpp"

namespace mbcc::graph {
namespace {

using test::Quad;
using test::Random;
using test::Tracked;

constexpr std::size_t variables = 4;
constexpr int wanted = 3000;

std::vector<Expr> leaves(Graph& graph) {
  std::vector<Expr> all;
  for (std::uint32_t i = 0; i < variables; ++i) {
    all.push_back(graph.leaf(Kind::Coordinate, i));
  }
  return all;
}

std::vector<double> random_point(Random& random, double low, double high) {
  std::vector<double> point(variables);
  for (double& x : point) {
    x = random.uniform(low, high);
  }
  return point;
}

std::string text_of(Expr expression) {
  return print(std::array{std::pair<std::string, Expr>{"f", expression}},
               [](const Node& node) { return "x" + std::to_string(node.index + 1); });
}

std::vector<double> unit(std::size_t i) {
  std::vector<double> direction(variables);
  direction[i] = 1;
  return direction;
}

/// f exactly as drawn, its first derivatives along c and d, and its second along both, with error bounds.
Dual<Dual<Tracked>> along_lines(Expr f, const std::vector<double>& x, const std::vector<double>& c,
                                const std::vector<double>& d) {
  const auto leaf = [&](const Node& node) -> Dual<Dual<Tracked>> {
    if (node.kind == Kind::Constant) {
      return {{Tracked(node.value), Tracked(0)}, {Tracked(0), Tracked(0)}};
    }
    return {{Tracked(x[node.index]), Tracked(d[node.index])}, {Tracked(c[node.index]), Tracked(0)}};
  };
  return evaluate<Dual<Dual<Tracked>>>(f.graph(), std::array{f}, leaf).front();
}

bool is_sharp(const Dual<Dual<Tracked>>& dual) {
  return test::is_sharp(dual.value.value) && test::is_sharp(dual.value.derivative) &&
         test::is_sharp(dual.derivative.derivative);
}

/// The same as graph, folded, in a graph of its own.
Dual<Dual<Expr>> symbolic(Expr f, Graph& folded, const std::vector<double>& d) {
  const auto leaf = [&](const Node& node) -> Dual<Dual<Expr>> {
    const Expr zero = folded.constant(0);
    if (node.kind == Kind::Constant) {
      return {{folded.constant(node.value), zero}, {zero, zero}};
    }
    const Expr along = folded.constant(d[node.index]);
    return {{folded.leaf(node.kind, node.index), along}, {along, zero}};
  };
  return evaluate<Dual<Dual<Expr>>>(f.graph(), std::array{f}, leaf).front();
}

template <class T>
std::vector<T> values(const std::vector<Expr>& roots, const std::vector<double>& x) {
  const auto leaf = [&](const Node& node) { return T(node.kind == Kind::Constant ? node.value : x[node.index]); };
  return evaluate<T>(roots.front().graph(), roots, leaf);
}

Feed feed_of(Expr f, const std::vector<double>& x) {
  const auto leaf = [&](const Node& node) {
    return node.kind == Kind::Constant ? Feed::constant(node.value, variables, Feed::Order::Second)
                                       : Feed::variable(x[node.index], node.index, variables, Feed::Order::Second);
  };
  return evaluate<Feed>(f.graph(), std::array{f}, leaf).front();
}

/// Calls `judge(f, x, d, along)` with random expressions that are smooth and well conditioned at x.
template <class Judge>
void with_random_expressions(std::uint64_t seed, const Judge& judge) {
  Random random(seed);
  for (int judged = 0; judged < wanted;) {
    Graph drawn;
    const Expr f = test::RandomExpressions(drawn, leaves(drawn), random).draw(5);
    const std::vector<double> x = random_point(random, -2, 2);
    const std::vector<double> d = random_point(random, -1, 1);
    const Dual<Dual<Tracked>> along = along_lines(f, x, d, d);
    if (f.level() == Level::State && is_sharp(along)) {
      ++judged;
      INFO(text_of(f));
      CAPTURE(x, d);
      judge(f, x, d, along);
    }
  }
}

}  // namespace

TEST_CASE("nested duals and the FEED form agree on random expressions, partial by partial") {
  with_random_expressions(1, [](Expr f, const auto& x, const auto&, const auto&) {
    const Feed feed = feed_of(f, x);
    for (std::size_t i = 0; i < variables; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        const Dual<Dual<Tracked>> dual = along_lines(f, x, unit(i), unit(j));
        CAPTURE(i, j);
        REQUIRE(feed.value() == dual.value.value.value);
        REQUIRE(test::agree(dual.value.derivative, feed.first(j)));
        REQUIRE(test::agree(dual.derivative.derivative, feed.second(i, j)));
      }
    }
  });
}

TEST_CASE("derivatives as folded graph have the values of derivatives as drawn") {
  with_random_expressions(2, [](Expr f, const auto& x, const auto& d, const Dual<Dual<Tracked>>& along) {
    Graph folded;
    const Dual<Dual<Expr>> dual = symbolic(f, folded, d);
    const std::vector<Tracked> got =
        values<Tracked>({dual.value.value, dual.value.derivative, dual.derivative.derivative}, x);
    const std::array expected = {along.value.value, along.value.derivative, along.derivative.derivative};
    for (std::size_t i = 0; i < 3; ++i) {
      CAPTURE(i, got[i].value, expected[i].value, expected[i].error);
      REQUIRE(std::abs(got[i].value - expected[i].value) <= 4 * (got[i].error + expected[i].error));
    }
  });
}

TEST_CASE("folding keeps the meaning of random expressions") {
  with_random_expressions(3, [](Expr f, const auto& x, const auto&, const Dual<Dual<Tracked>>& along) {
    Graph folded;
    const auto leaf = [&](const Node& node) {
      return node.kind == Kind::Constant ? folded.constant(node.value) : folded.leaf(node.kind, node.index);
    };
    const Expr g = evaluate<Expr>(f.graph(), std::array{f}, leaf).front();
    const Quad difference = values<Quad>({f}, x).front() - values<Quad>({g}, x).front();
    // In quadruple precision nothing is left but the rounding of constants that were folded in double.
    REQUIRE(abs(difference) <= 4 * along.value.value.error);
  });
}

}  // namespace mbcc::graph
