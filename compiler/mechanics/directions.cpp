#include "mechanics/directions.hpp"

#include <algorithm>

#include "graph/dual.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Dual;
using graph::Graph;
using graph::Node;

Expr same_leaf(Graph& graph, const Node& node) {
  return node.kind == Kind::Constant ? graph.constant(node.value) : graph.leaf(node.kind, node.index);
}

}  // namespace

Expr partial(Expr expression, Kind kind, std::uint32_t index) {
  Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Expr> {
    return {same_leaf(graph, node), graph.constant(node.kind == kind && node.index == index ? 1 : 0)};
  };
  return graph::evaluate<Dual<Expr>>(graph, std::array{expression}, seed).front().derivative;
}

std::vector<std::uint32_t> occurring(Expr expression, Kind kind) {
  std::vector<std::uint32_t> indices;
  for (const graph::NodeId id : graph::reachable(expression.graph(), std::array{expression})) {
    const Node& node = expression.graph()[id];
    if (node.kind == kind) {
      indices.push_back(node.index);
    }
  }
  std::sort(indices.begin(), indices.end());
  return indices;
}

std::map<std::size_t, Expr> partials_along_speeds(Expr expression) {
  std::map<std::size_t, Expr> partials;
  for (const std::uint32_t speed : occurring(expression, Kind::Speed)) {
    const Expr value = partial(expression, Kind::Speed, speed);
    if (!is_zero(value)) {
      partials.emplace(speed, value);
    }
  }
  return partials;
}

Expr with_rates(Expr expression, const std::vector<Expr>& rates) {
  Graph& graph = expression.graph();
  const auto leaf = [&](const Node& node) {
    return node.kind == Kind::CoordinateRate ? rates[node.index] : same_leaf(graph, node);
  };
  return graph::evaluate<Expr>(graph, std::array{expression}, leaf).front();
}

UnacceleratedMotion::UnacceleratedMotion(const std::vector<Expr>& kinematics) : kinematics_(kinematics) {
  for (const Expr velocity : kinematics_) {
    second_.push_back(rate(velocity));
  }
}

Expr UnacceleratedMotion::rate(Expr expression) const {
  Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Expr> {
    return {same_leaf(graph, node), node.kind == Kind::Time         ? graph.constant(1)
                                    : node.kind == Kind::Coordinate ? kinematics_[node.index]
                                                                    : graph.constant(0)};
  };
  return graph::evaluate<Dual<Expr>>(graph, std::array{expression}, seed).front().derivative;
}

UnacceleratedMotion::Rates UnacceleratedMotion::rates(Expr expression) const {
  Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Dual<Expr>> {
    const Expr zero = graph.constant(0);
    if (node.kind == Kind::Coordinate) {
      return {{same_leaf(graph, node), kinematics_[node.index]}, {kinematics_[node.index], second_[node.index]}};
    }
    const Expr rate = graph.constant(node.kind == Kind::Time ? 1 : 0);
    return {{same_leaf(graph, node), rate}, {rate, zero}};
  };
  const Dual<Dual<Expr>> motion = graph::evaluate<Dual<Dual<Expr>>>(graph, std::array{expression}, seed).front();
  return {motion.value.derivative, motion.derivative.derivative};
}

}  // namespace mbcc::mechanics
