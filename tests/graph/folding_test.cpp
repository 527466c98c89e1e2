// Note [folding], line by line.

#include <catch2/catch.hpp>
#include <limits>

#include "graph/print.hpp"

namespace mbcc::graph {
namespace {

/// Coordinates named a, b, c in a graph of their own.
struct Letters {
  Graph graph;
  Expr a = graph.leaf(Kind::Coordinate, 0);
  Expr b = graph.leaf(Kind::Coordinate, 1);
  Expr c = graph.leaf(Kind::Coordinate, 2);

  Expr n(double x) { return graph.constant(x); }
};

std::string shown(Expr expression) {
  const std::string line = print(std::array{std::pair<std::string, Expr>{"", expression}},
                                 [](const Node& node) { return std::string(1, static_cast<char>('a' + node.index)); });
  return line.substr(3, line.size() - 4);  // behind " = ", before the line's end
}

}  // namespace

TEST_CASE("constants fold where the result is finite") {
  Letters l;
  CHECK((l.n(2) + l.n(3)).is_constant(5));
  CHECK(pow(l.n(2), l.n(10)).is_constant(1024));
  CHECK(pow(l.n(0), l.n(0)).is_constant(1));
  CHECK(sign(l.n(0)).is_constant(0));
  CHECK_FALSE((l.n(1) / l.n(0)).is_constant());
  CHECK_FALSE(log(l.n(-1)).is_constant());
  CHECK_FALSE((l.n(1e300) * l.n(1e300)).is_constant());
  CHECK(shown(l.n(1) / l.n(0)) == "1 / 0");
}

TEST_CASE("a zero that folding makes has no sign") {
  Letters l;
  CHECK_FALSE(std::signbit((l.n(-1) * l.n(0)).node().value));
  CHECK_FALSE(std::signbit((l.n(0) * -l.a).node().value));
}

TEST_CASE("numeric factors move to the front and merge") {
  Letters l;
  CHECK(shown(l.n(2) * l.a * (l.n(3) * l.b)) == "6 * (a * b)");
  CHECK(shown(l.a * l.n(2)) == "2 * a");
  CHECK(shown(l.n(2) * l.a + l.n(2) * l.b) == "2 * (a + b)");
  CHECK(shown(l.n(2) * l.a - l.n(2) * l.b) == "2 * (a - b)");
  CHECK(shown(l.n(2) * l.a + l.n(3) * l.a) == "5 * a");
  CHECK(shown(l.n(2) * l.a - l.n(3) * l.b) == "2 * a - 3 * b");
  CHECK(shown(l.a + l.a) == "2 * a");
  CHECK(shown(l.a / l.n(4)) == "0.25 * a");
  CHECK(shown(l.n(6) * l.a / (l.n(2) * l.b)) == "3 * (a / b)");
  CHECK(shown(l.n(6) / (l.n(2) * l.b)) == "3 / b");
  CHECK(shown((-l.a) * (-l.b)) == "a * b");
  CHECK(shown((-l.a) * l.b) == "-a * b");
  CHECK(shown(l.a + -l.b) == "a - b");
  CHECK(shown(l.a - -l.b) == "a + b");
  CHECK(shown(-l.a - l.b) == "-(a + b)");
  CHECK(shown(-(l.a - l.b)) == "-(a - b)");
}

TEST_CASE("neutral elements disappear") {
  Letters l;
  CHECK(l.a + l.n(0) == l.a);
  CHECK(l.n(0) + l.a == l.a);
  CHECK(l.a - l.n(0) == l.a);
  CHECK(l.n(1) * l.a == l.a);
  CHECK(l.a / l.n(1) == l.a);
  CHECK(pow(l.a, l.n(1)) == l.a);
  CHECK(-(-l.a) == l.a);
  CHECK(shown(l.n(0) - l.a) == "-a");
}

TEST_CASE("what costs an infinity or a NaN is what the note names") {
  Letters l;
  const Expr hole = log(l.a);
  CHECK((hole - hole).is_constant(0));
  CHECK((l.n(0) * hole).is_constant(0));
  CHECK(pow(hole, l.n(0)).is_constant(1));
  CHECK((l.n(0) / hole).is_constant(0));
  CHECK((hole / hole).is_constant(1));
  CHECK(pow(l.n(1), hole).is_constant(1));
}

TEST_CASE("squares exist once however they are written") {
  Letters l;
  CHECK(l.a * l.a == pow(l.a, l.n(2)));
  CHECK(pow(-l.a, l.n(2)) == pow(l.a, l.n(2)));
  CHECK(shown(pow(-l.a, l.n(3))) == "-a^3");
  CHECK(shown(pow(l.n(2) * l.a, l.n(3))) == "8 * a^3");
  CHECK((l.n(2) * l.a) * (l.n(2) * l.a) == pow(l.n(2) * l.a, l.n(2)));
  // Not for other exponents, where a sign or a factor has no real power.
  CHECK(shown(pow(-l.a, l.n(0.5))) == "(-a)^0.5");
}

TEST_CASE("sums and products are ordered, and nothing is reassociated") {
  Letters l;
  CHECK(l.a + l.b == l.b + l.a);
  CHECK(l.a * l.b == l.b * l.a);
  CHECK(l.a - l.b != l.b - l.a);
  CHECK(l.b - l.a == -(l.a - l.b));
  CHECK((l.a + l.b) + l.c != l.a + (l.b + l.c));
}

TEST_CASE("squares of sine and cosine of one angle add up to one") {
  Letters l;
  CHECK((pow(sin(l.a), l.n(2)) + cos(l.a) * cos(l.a)).is_constant(1));
  CHECK_FALSE((pow(sin(l.a), l.n(2)) + pow(cos(l.b), l.n(2))).is_constant());
  CHECK_FALSE((pow(sin(l.a), l.n(2)) + pow(sin(l.a), l.n(2))).is_constant());
  CHECK_FALSE((pow(sin(l.a), l.n(2)) - pow(cos(l.a), l.n(2))).is_constant());
}

TEST_CASE("a decided `if` is its side") {
  Letters l;
  CHECK(select(l.n(1), l.a, l.b) == l.a);
  CHECK(select(l.n(0), l.a, l.b) == l.b);
  CHECK(select(less(l.a, l.b), l.c, l.c) == l.c);
  CHECK(select(less(l.n(1), l.n(2)), l.a, log(l.n(-1))) == l.a);
}

TEST_CASE("factors do not merge where the result would overflow or vanish") {
  Letters l;
  const double huge = std::numeric_limits<double>::max();
  const double tiny = 1e-310;
  for (const Expr e : {l.n(huge) * l.a * l.n(2), l.n(huge) * l.a + l.n(huge) * l.a, l.n(huge) * l.a - l.n(-huge) * l.a,
                       l.a / l.n(tiny), l.n(huge) * l.a / l.n(0.5), l.n(huge) * l.a / (l.n(0.5) * l.a),
                       l.n(tiny) * l.a / (l.n(huge) * l.b), pow(l.n(1e200) * l.a, l.n(2))}) {
    CHECK(shown(e).find("inf") == std::string::npos);
    CHECK_FALSE(e.is_constant());
  }
}

}  // namespace mbcc::graph
