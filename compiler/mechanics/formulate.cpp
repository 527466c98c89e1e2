#include <algorithm>

#include "diagnostics/assert.hpp"
#include "graph/dual.hpp"
#include "mechanics/directions.hpp"
#include "mechanics/equations.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Dual;
using graph::Graph;
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

/// Rates of coordinates as they occur in energies: speeds where they are speeds, else leaves of their own.
std::vector<Expr> symbolic_rates(const model::System& system, Graph& graph) {
  std::vector<Expr> rates;
  for (std::uint32_t i = 0; i < system.coordinates.size(); ++i) {
    const std::optional<model::SpeedId> speed = system.speed_of(system.coordinates[i]);
    rates.push_back(speed ? graph.leaf(Kind::Speed, index(*speed)) : graph.leaf(Kind::CoordinateRate, i));
  }
  return rates;
}

/// Puts rates into each other until none is left. There is no cycle among them.
std::vector<Expr> resolved(std::vector<Expr> rates) {
  const auto is_open = [](Expr rate) { return !occurring(rate, Kind::CoordinateRate).empty(); };
  while (std::any_of(rates.begin(), rates.end(), is_open)) {
    const std::vector<Expr> known = rates;
    for (Expr& rate : rates) {
      rate = with_rates(rate, known);
    }
  }
  return rates;
}

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
  const std::vector<Expr> rates = symbolic_rates(system, graph);
  const Lowering symbolic(system, graph, rates);
  equations.kinetic = select(system.kinetic, &model::Energy::value, symbolic);
  equations.kinematics = resolved(select(system.coordinates, &model::Coordinate::rate, symbolic));
  const Lowering lowering(system, graph, equations.kinematics);
  equations.initial_coordinates = select(system.coordinates, &model::Coordinate::initial, lowering);
  equations.initial_speeds = select(system.speeds, &model::Speed::initial, lowering);
  resolve_starts(system.start_order, equations, graph);
  equations.inertia = select(system.speeds, &model::Speed::inertia, lowering);
  equations.forces = select(system.forces, &model::Force::value, lowering);
  equations.force_velocities = select(system.forces, &model::Force::along, lowering);
  equations.potential = select(system.potential, &model::Energy::value, lowering);
  equations.constraints = select(system.constraints, &model::Constraint::value, lowering);
  equations.outputs = select(system.outputs, &model::Output::value, lowering);
  return equations;
}

}  // namespace mbcc::mechanics
