#include <algorithm>
#include <cmath>

#include "graph/dual.hpp"
#include "mechanics/collect.hpp"
#include "mechanics/derivatives.hpp"
#include "mechanics/islands.hpp"
#include "mechanics/redundancy.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Dual;
using graph::Graph;
using graph::Kind;
using graph::Level;
using graph::Node;

Expr same_leaf(Graph& graph, const Node& node) {
  return node.kind == Kind::Constant ? graph.constant(node.value) : graph.leaf(node.kind, node.index);
}

struct Rates {
  Expr first;
  Expr second;
};

/// First and second time derivative along the motion with u' = 0: t' = 1, q' = u, all else rests.
Rates along_unaccelerated_motion(Expr expression, const std::vector<Expr>& kinematics) {
  Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Dual<Expr>> {
    const Expr zero = graph.constant(0);
    const Expr rate = node.kind == Kind::Time         ? graph.constant(1)
                      : node.kind == Kind::Coordinate ? kinematics[node.index]
                                                      : zero;
    return {{same_leaf(graph, node), rate}, {rate, zero}};
  };
  const Dual<Dual<Expr>> motion = graph::evaluate<Dual<Dual<Expr>>>(graph, std::array{expression}, seed).front();
  return {motion.value.derivative, motion.derivative.derivative};
}

/// Indices of the leaves of one kind that occur in `expression`, increasing.
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

std::vector<Entry> entries_of(const model::System& system, Expr constraint, bool holonomic) {
  std::vector<Entry> entries;
  const Kind kind = holonomic ? Kind::Coordinate : Kind::Speed;
  for (const std::uint32_t index : occurring(constraint, kind)) {
    const Expr value = partial(constraint, kind, index);
    if (!is_zero(value)) {
      entries.push_back({holonomic ? model::index(system.coordinates[index].rate) : index, value});
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.speed < b.speed; });
  return entries;
}

/// The size of the numeric factor of the entries, if it is the same in all: 2 for a squared distance.
double content_of(const std::vector<Entry>& entries) {
  const double content = entries.empty() ? 1 : std::abs(numeric_factor(entries.front().value));
  const bool shared = std::all_of(entries.begin(), entries.end(), [content](const Entry& entry) {
    return std::abs(numeric_factor(entry.value)) == content;
  });
  return shared && content > 0 ? content : 1;
}

Row differentiate_constraint(const model::System& system, const Equations& equations, std::size_t k,
                             const std::vector<Expr>& free) {
  const Expr value = equations.constraints[k];
  const bool holonomic = system.constraints[k].holonomic;
  const Rates rates = along_unaccelerated_motion(value, equations.kinematics);
  const Expr b = collect(holonomic ? -rates.second : -rates.first);
  Row row{k, entries_of(system, value, holonomic), b, value, holonomic ? collect(rates.first) : value, b, 1};
  Expr of_free_motion = number(value, 0);
  for (const Entry& entry : row.entries) {
    of_free_motion = of_free_motion + entry.value * free[entry.speed];
  }
  row.residual = collect(b - of_free_motion);
  row.content = content_of(row.entries);
  return row;
}

std::vector<Expr> sum_of_forces(const model::System& system, const Equations& equations, Graph& graph) {
  std::vector<Expr> total(system.speeds.size(), graph.constant(0));
  for (std::size_t i = 0; i < system.forces.size(); ++i) {
    Expr& force = total[model::index(system.forces[i].speed)];
    force = force + equations.forces[i];
  }
  return total;
}

/// Kinetic energy, less the work of the constant forces; nothing where a force is not constant.
std::optional<Expr> energy_of(const model::System& system, const Equations& equations, const std::vector<Expr>& forces,
                              Graph& graph) {
  if (std::any_of(forces.begin(), forces.end(), [](Expr force) { return force.level() > Level::Parameter; })) {
    return std::nullopt;
  }
  Expr energy = graph.constant(0);
  for (std::uint32_t j = 0; j < system.speeds.size(); ++j) {
    const Expr speed = graph.leaf(Kind::Speed, j);
    energy = energy + graph.constant(0.5) * equations.inertia[j] * speed * speed;
  }
  for (std::uint32_t i = 0; i < system.coordinates.size(); ++i) {
    energy = energy - forces[model::index(system.coordinates[i].rate)] * graph.leaf(Kind::Coordinate, i);
  }
  return energy;
}

}  // namespace

Derivatives differentiate(const model::System& system, const Equations& equations, Graph& graph) {
  Derivatives derivatives;
  const std::vector<Expr> forces = sum_of_forces(system, equations, graph);
  for (std::size_t j = 0; j < system.speeds.size(); ++j) {
    derivatives.mobility.push_back(graph.constant(1) / equations.inertia[j]);
    derivatives.free.push_back(forces[j] / equations.inertia[j]);
  }
  for (std::size_t k = 0; k < equations.constraints.size(); ++k) {
    derivatives.rows.push_back(differentiate_constraint(system, equations, k, derivatives.free));
  }
  derivatives.islands = find_islands(derivatives.rows, system.speeds.size());
  for (Island& island : derivatives.islands) {
    island.held = find_implied_rows(island, system, equations, derivatives);
    std::erase_if(island.rows, [&](std::size_t row) {
      return std::find(island.held.begin(), island.held.end(), row) != island.held.end();
    });
    island.rows = elimination_order(derivatives.rows, island.rows);
  }
  derivatives.energy = energy_of(system, equations, forces, graph);
  return derivatives;
}

}  // namespace mbcc::mechanics
