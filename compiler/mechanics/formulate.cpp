#include "diagnostics/assert.hpp"
#include "graph/dual.hpp"
#include "mechanics/equations.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Dual;
using graph::Graph;
using graph::Kind;
using graph::Node;
using model::ExpressionId;
using model::ExpressionKind;
using model::index;

/// Lowers the System's expression arena into the graph, each entry once.
class Lowering {
 public:
  Lowering(const model::System& system, Graph& graph, const std::vector<Expr>& kinematics)
      : graph_(graph), kinematics_(kinematics) {
    lowered_.reserve(system.expressions.size());
    for (const model::Expression& expression : system.expressions) {
      lowered_.push_back(lower(expression));
    }
  }

  Expr operator[](ExpressionId id) const { return lowered_[index(id)]; }

 private:
  Expr lower(const model::Expression& expression) {
    switch (expression.kind) {
      case ExpressionKind::Number:
        return graph_.constant(expression.number);
      case ExpressionKind::Time:
        return graph_.leaf(Kind::Time);
      case ExpressionKind::Coordinate:
        return graph_.leaf(Kind::Coordinate, expression.index);
      case ExpressionKind::Speed:
        return graph_.leaf(Kind::Speed, expression.index);
      case ExpressionKind::Parameter:
        return graph_.leaf(Kind::Parameter, expression.index);
      case ExpressionKind::Apply:
        return lower_application(expression);
      case ExpressionKind::Share:
        return partial(operand(expression, 0), Kind::Speed, expression.index);
      case ExpressionKind::Rate:
        return rates_of({operand(expression, 0)}, kinematics_).front();
    }
    MBCC_ASSERT(false);
    return {};
  }

  Expr lower_application(const model::Expression& expression) {
    std::array<Expr, 3> operands;
    const auto count = static_cast<std::size_t>(graph::arity(expression.op));
    for (std::size_t i = 0; i < count; ++i) {
      operands[i] = operand(expression, i);
    }
    return graph_.apply(expression.op, {operands.data(), count});
  }

  Expr operand(const model::Expression& expression, std::size_t i) const { return (*this)[expression.operands[i]]; }

  Graph& graph_;
  const std::vector<Expr>& kinematics_;
  std::vector<Expr> lowered_;
};

template <class Item, class Member>
std::vector<Expr> select(const std::vector<Item>& items, Member member, const Lowering& lowering) {
  std::vector<Expr> selected;
  selected.reserve(items.size());
  for (const Item& item : items) {
    selected.push_back(lowering[item.*member]);
  }
  return selected;
}

/// Replaces coordinates and speeds in the starts by their own starts.
void resolve_starts(const std::vector<std::size_t>& order, Equations& equations, Graph& graph) {
  const std::size_t coordinates = equations.initial_coordinates.size();
  const auto start = [&](const Node& node) -> Expr {
    switch (node.kind) {
      case Kind::Coordinate:
        return equations.initial_coordinates[node.index];
      case Kind::Speed:
        return equations.initial_speeds[node.index];
      case Kind::Constant:
        return graph.constant(node.value);
      default:
        return graph.leaf(node.kind, node.index);
    }
  };
  for (const std::size_t i : order) {
    Expr& value = i < coordinates ? equations.initial_coordinates[i] : equations.initial_speeds[i - coordinates];
    if (value.level() > graph::Level::Parameter) {
      value = graph::evaluate<Expr>(graph, std::array{value}, start).front();
    }
  }
}

}  // namespace

Expr partial(Expr expression, Kind kind, std::uint32_t index) {
  Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Expr> {
    const Expr leaf = node.kind == Kind::Constant ? graph.constant(node.value) : graph.leaf(node.kind, node.index);
    return {leaf, graph.constant(node.kind == kind && node.index == index ? 1 : 0)};
  };
  return graph::evaluate<Dual<Expr>>(graph, std::array{expression}, seed).front().derivative;
}

std::vector<Expr> rates_of(const std::vector<Expr>& expressions, const std::vector<Expr>& kinematics) {
  if (expressions.empty()) {
    return {};
  }
  Graph& graph = expressions.front().graph();
  const auto along_motion = [&](const Node& node) -> Dual<Expr> {
    const Expr zero = graph.constant(0);
    switch (node.kind) {
      case Kind::Time:
        return {graph.leaf(Kind::Time), graph.constant(1)};
      case Kind::Coordinate:
        return {graph.leaf(Kind::Coordinate, node.index), kinematics[node.index]};
      case Kind::Speed:
        return {graph.leaf(Kind::Speed, node.index), graph.leaf(Kind::Acceleration, node.index)};
      case Kind::Constant:
        return {graph.constant(node.value), zero};
      default:
        return {graph.leaf(node.kind, node.index), zero};
    }
  };
  std::vector<Expr> rates;
  for (const Dual<Expr>& dual : graph::evaluate<Dual<Expr>>(graph, expressions, along_motion)) {
    rates.push_back(dual.derivative);
  }
  return rates;
}

Equations formulate(const model::System& system, Graph& graph) {
  Equations equations;
  for (const model::Coordinate& coordinate : system.coordinates) {
    equations.kinematics.push_back(graph.leaf(Kind::Speed, index(coordinate.rate)));
  }
  const Lowering lowering(system, graph, equations.kinematics);
  equations.initial_coordinates = select(system.coordinates, &model::Coordinate::initial, lowering);
  equations.initial_speeds = select(system.speeds, &model::Speed::initial, lowering);
  resolve_starts(system.start_order, equations, graph);
  equations.inertia = select(system.speeds, &model::Speed::inertia, lowering);
  equations.forces = select(system.forces, &model::Force::value, lowering);
  equations.constraints = select(system.constraints, &model::Constraint::value, lowering);
  equations.outputs = select(system.outputs, &model::Output::value, lowering);
  return equations;
}

}  // namespace mbcc::mechanics
