#include "mechanics/tangent.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "graph/dual.hpp"
#include "mechanics/uncouple.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Dual;
using graph::Kind;
using graph::Node;

/// The derivative of `expression` along the direction that the leaves CoordinateChange and SpeedChange are.
Expr change_of(Expr expression) {
  graph::Graph& graph = expression.graph();
  const auto seed = [&](const Node& node) -> Dual<Expr> {
    const Expr value = node.kind == Kind::Constant ? graph.constant(node.value) : graph.leaf(node.kind, node.index);
    return {value, node.kind == Kind::Coordinate ? graph.leaf(Kind::CoordinateChange, node.index)
                   : node.kind == Kind::Speed    ? graph.leaf(Kind::SpeedChange, node.index)
                                                 : graph.constant(0)};
  };
  return graph::evaluate<Dual<Expr>>(graph, std::array{expression}, seed).front().derivative;
}

/// Accelerations, coupled and uncoupled, and multipliers at the state.
struct Motion {
  std::vector<Expr> accelerations;               ///< by speed
  std::vector<Expr> uncoupled;                   ///< likewise
  std::vector<std::optional<Expr>> multipliers;  ///< by row, of those that are solved
};

Motion motion_of(const Derivatives& derivatives, const std::vector<const Elimination*>& solutions) {
  Motion motion{derivatives.free, {}, std::vector<std::optional<Expr>>(derivatives.rows.size())};
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const Island& island = derivatives.islands[i];
    for (std::size_t j = 0; j < island.speeds.size(); ++j) {
      motion.accelerations[island.speeds[j]] = solutions[i]->accelerations[j];
    }
    for (std::size_t k = 0; k < island.rows.size(); ++k) {
      motion.multipliers[island.rows[k]] = solutions[i]->multipliers[k];
    }
  }
  motion.uncoupled = uncoupled(derivatives.couplings, motion.accelerations);
  return motion;
}

/// dL^T u' of each speed.
std::vector<Expr> changes_of_couplings(const Derivatives& derivatives, const Motion& motion) {
  std::vector<Expr> changes;
  for (const Expr acceleration : motion.accelerations) {
    changes.push_back(number(acceleration, 0));
  }
  for (const Coupling& coupling : derivatives.couplings) {
    for (const Entry& term : coupling.terms) {
      changes[coupling.speed] = changes[coupling.speed] + change_of(term.value) * motion.accelerations[term.speed];
    }
  }
  return changes;
}

/// d(a + M^-1 A^T z) at constant z.
std::vector<Expr> free_changes(const Derivatives& derivatives, const Motion& motion) {
  std::vector<Expr> free;
  std::transform(derivatives.free.begin(), derivatives.free.end(), std::back_inserter(free), change_of);
  for (const Row& row : derivatives.rows) {
    if (const auto& multiplier = motion.multipliers[row.constraint]) {
      for (const Entry& entry : row.solved) {
        const Expr along = as_solved(row, entry.value) * derivatives.mobility[entry.speed];
        free[entry.speed] = free[entry.speed] + change_of(along) * *multiplier;
      }
    }
  }
  return free;
}

}  // namespace

Tangent differentiate_along_direction(const Equations& equations, const Derivatives& derivatives,
                                      const std::vector<const Elimination*>& solutions) {
  Tangent tangent{{}, derivatives};
  std::transform(equations.kinematics.begin(), equations.kinematics.end(), std::back_inserter(tangent.kinematics),
                 change_of);
  const Motion motion = motion_of(derivatives, solutions);
  const std::vector<Expr> free = free_changes(derivatives, motion);
  const std::vector<Expr> couplings = changes_of_couplings(derivatives, motion);
  for (Row& row : tangent.equations.rows) {
    if (!motion.multipliers[row.constraint]) {
      continue;
    }
    Expr b = change_of(row.b);
    for (const Entry& entry : row.solved) {
      b = b - change_of(entry.value) * motion.uncoupled[entry.speed];
    }
    row.b = row.residual = b;
    for (const Entry& entry : row.solved) {
      row.b = row.b - entry.value * couplings[entry.speed];
      row.residual = row.residual - entry.value * free[entry.speed];
    }
  }
  for (std::size_t j = 0; j < free.size(); ++j) {
    tangent.equations.free[j] = free[j] - couplings[j];
  }
  return tangent;
}

}  // namespace mbcc::mechanics
