#include "program/lower.hpp"

#include <cmath>
#include <unordered_set>

#include "graph/evaluate.hpp"

namespace mbcc::program {

namespace {

using graph::Expr;
using graph::Graph;
using graph::Kind;
using graph::Node;
using graph::NodeId;
using graph::Operator;

constexpr int divisions_worth_a_reciprocal = 3;

/// The denominators whose reciprocal is worth a value of its own.
std::unordered_set<NodeId> find_shared_denominators(const Graph& graph, const std::vector<NodeId>& nodes) {
  std::unordered_map<NodeId, int> divisions;
  std::unordered_set<NodeId> shared;
  for (const NodeId id : nodes) {
    const Node& node = graph[id];
    if (node.kind == Kind::Apply && node.op == Operator::Divide) {
      const NodeId denominator = node.operands[1];
      const bool known_earlier = graph[denominator].level < graph[node.operands[0]].level;
      if (++divisions[denominator] >= divisions_worth_a_reciprocal || known_earlier) {
        shared.insert(denominator);
      }
    }
  }
  return shared;
}

}  // namespace

Lowering::Lowering(std::span<const Expr> roots, Graph& lowered) : lowered_(lowered) {
  if (roots.empty()) {
    return;
  }
  const Graph& graph = roots.front().graph();
  const std::vector<NodeId> nodes = graph::reachable(graph, roots);
  shared_denominators_ = find_shared_denominators(graph, nodes);
  for (const NodeId id : nodes) {
    images_.emplace(id, lower(graph, graph[id]));
  }
}

Expr Lowering::lower(const Graph& graph, const Node& node) {
  if (node.kind == Kind::Constant) {
    return lowered_.constant(node.value);
  }
  if (node.kind != Kind::Apply) {
    return lowered_.leaf(node.kind, node.index);
  }
  std::array<Expr, 3> operands;
  for (std::size_t i = 0; i < node.used_operands().size(); ++i) {
    operands[i] = images_.at(node.operands[i]);
  }
  if (node.op == Operator::Power) {
    const Node& exponent = graph[node.operands[1]];
    if (exponent.kind == Kind::Constant && std::floor(exponent.value) == exponent.value &&
        std::abs(exponent.value) <= graph::largest_multiplied_exponent) {
      const Expr power = integer_power(operands[0], static_cast<int>(std::abs(exponent.value)));
      return exponent.value > 0 ? power : reciprocal(power);
    }
  }
  if (node.op == Operator::Divide && shared_denominators_.contains(node.operands[1])) {
    return operands[0].is_constant(1) ? reciprocal(operands[1])
                                      : make(Operator::Multiply, operands[0], reciprocal(operands[1]));
  }
  return lowered_.intern(node.op, {operands.data(), node.used_operands().size()});
}

Expr Lowering::make(Operator op, Expr a, Expr b) { return lowered_.intern(op, std::array{a, b}); }

Expr Lowering::reciprocal(Expr x) { return make(Operator::Divide, lowered_.constant(1), x); }

Expr Lowering::integer_power(Expr base, int exponent) {
  if (exponent == 1) {
    return base;
  }
  const Expr half = integer_power(base, exponent / 2);
  const Expr square = make(Operator::Multiply, half, half);
  return exponent % 2 == 0 ? square : make(Operator::Multiply, square, base);
}

}  // namespace mbcc::program
