// The graph itself: every expression once, operands first, levels; and how it prints.

#include <catch2/catch.hpp>
#include <cmath>

#include "graph/evaluate.hpp"
#include "graph/print.hpp"

namespace mbcc::graph {
namespace {

std::string letter(const Node& node) {
  return node.kind == Kind::Time ? "t" : std::string(1, static_cast<char>('a' + node.index));
}

std::string printed(const std::vector<std::pair<std::string, Expr>>& labelled) { return print(labelled, letter); }

}  // namespace

TEST_CASE("equal expressions are the same node") {
  Graph graph;
  const Expr a = graph.leaf(Kind::Coordinate, 0);
  const Expr b = graph.leaf(Kind::Coordinate, 1);
  const std::size_t size = graph.size();
  CHECK(graph.leaf(Kind::Coordinate, 0) == a);
  CHECK(graph.size() == size);
  CHECK(sin(a * b) == sin(b * a));
  CHECK(sin(a) != cos(a));
  CHECK(graph.leaf(Kind::Speed, 0) != a);
  CHECK(graph.constant(0.1) == graph.constant(0.1));
  CHECK(graph.constant(0.1) != graph.constant(0.1 + 1e-17 + 1e-16));
  CHECK(graph.constant(0.0) != graph.constant(-0.0));
  CHECK(graph.constant(std::nan("")) == graph.constant(std::nan("")));
}

TEST_CASE("operands come before what uses them") {
  Graph graph;
  Expr x = graph.leaf(Kind::Coordinate, 0);
  for (int i = 0; i < 100; ++i) {
    x = sin(x) * x + graph.leaf(Kind::Coordinate, static_cast<std::uint32_t>(i));
  }
  for (NodeId id = 0; id < graph.size(); ++id) {
    for (const NodeId operand : graph[id].used_operands()) {
      CHECK(operand < id);
    }
  }
}

TEST_CASE("a level is the largest of the operands'") {
  Graph graph;
  const Expr number = graph.constant(2);
  const Expr parameter = graph.leaf(Kind::Parameter, 0);
  const Expr time = graph.leaf(Kind::Time);
  CHECK(number.level() == Level::Constant);
  CHECK((sin(parameter) * number).level() == Level::Parameter);
  CHECK((parameter + time).level() == Level::Time);
  for (const Kind kind : {Kind::Coordinate, Kind::Speed, Kind::Acceleration}) {
    CHECK((graph.leaf(kind, 0) * sin(parameter * time)).level() == Level::State);
  }
}

TEST_CASE("evaluation visits what the roots need, once") {
  Graph graph;
  const Expr a = graph.leaf(Kind::Coordinate, 0);
  const Expr unused = exp(a);
  Expr x = a;
  for (int i = 0; i < 50; ++i) {
    x = x + sin(x);  // 2^50 paths
  }
  int visits = 0;
  const auto leaf = [&](const Node&) {
    ++visits;
    return 0.0;
  };
  CHECK(evaluate<double>(graph, std::array{x, x}, leaf) == std::vector<double>{0, 0});
  CHECK(visits == 1);
  const std::vector<NodeId> order = reachable(graph, std::array{x});
  CHECK(order.size() == 101);
  CHECK(std::find(order.begin(), order.end(), unused.id()) == order.end());
}

TEST_CASE("expressions print in the language of models, with parentheses only where they are needed") {
  Graph graph;
  const Expr a = graph.leaf(Kind::Coordinate, 0), b = graph.leaf(Kind::Coordinate, 1);
  const Expr c = graph.leaf(Kind::Coordinate, 2);
  const auto n = [&](double x) { return graph.constant(x); };
  const auto shown = [&](Expr e) { return printed({{"f", e}}); };
  CHECK(shown(a - (b - c)) == "f = a - (b - c)\n");
  CHECK(shown((a - b) - c) == "f = a - b - c\n");
  CHECK(shown(a / (b / c)) == "f = a / (b / c)\n");
  CHECK(shown((a + b) * c) == "f = c * (a + b)\n");
  CHECK(shown(pow(a, pow(b, c))) == "f = a^(b^c)\n");
  CHECK(shown(pow(pow(a, b), c)) == "f = a^b^c\n");
  CHECK(shown(pow(a + b, n(2))) == "f = (a + b)^2\n");
  CHECK(shown(pow(a, n(-2))) == "f = a^(-2)\n");
  CHECK(shown(-pow(a, n(2))) == "f = -a^2\n");
  CHECK(shown(pow(-a, b)) == "f = (-a)^b\n");
  CHECK(shown(a * -sin(b)) == "f = -a * sin(b)\n");
  CHECK(shown(select(less(a, b), a, n(-1))) == "f = if(a < b, a, -1)\n");
  CHECK(shown(atan2(a, minimum(b, c))) == "f = atan2(a, min(b, c))\n");
  CHECK(shown(n(0.1)) == "f = 0.1\n");
}

TEST_CASE("what several expressions share is printed once, before them") {
  Graph graph;
  const Expr a = graph.leaf(Kind::Coordinate, 0);
  const Expr shared = sin(a);
  CHECK(printed({{"f", exp(shared)}, {"g", cos(shared)}}) == "#1 = sin(a)\nf = exp(#1)\ng = cos(#1)\n");
  CHECK(printed({}).empty());
}

}  // namespace mbcc::graph
