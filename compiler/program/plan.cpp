#include "program/plan.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mechanics/corrections.hpp"
#include "mechanics/directions.hpp"
#include "mechanics/tangent.hpp"
#include "mechanics/uncouple.hpp"

namespace mbcc::program {

namespace {

using graph::Expr;
using graph::Kind;
using mechanics::Derivatives;
using mechanics::Entry;
using mechanics::Equations;
using mechanics::Island;
using mechanics::Row;

std::vector<Wanted> all_of(Target target, const std::vector<Expr>& values, std::size_t first_index = 0) {
  std::vector<Wanted> wanted;
  for (const Expr value : values) {
    wanted.push_back({target, first_index, value, first_index});
    ++first_index;
  }
  return wanted;
}

std::vector<Wanted> rows_of(const Island& island, const model::System& system, const Derivatives& derivatives) {
  std::vector<Wanted> wanted;
  const std::size_t columns = island.speeds.size();
  const auto column_of = [&](std::size_t speed) {
    return static_cast<std::size_t>(std::lower_bound(island.speeds.begin(), island.speeds.end(), speed) -
                                    island.speeds.begin());
  };
  for (std::size_t k = 0; k < island.rows.size(); ++k) {
    const Row& row = derivatives.rows[island.rows[k]];
    // The rows as the plain solve has them: floors are theirs.
    for (const Entry& entry : row.solved) {
      wanted.push_back({Target::Matrix, k * columns + column_of(entry.speed), as_solved(row, entry.value), k});
    }
    wanted.push_back({Target::Residual, k, as_solved(row, row.residual), k});
    if (system.constraints[row.constraint].holonomic) {
      wanted.push_back({Target::RowPosition, k, as_solved(row, row.value), k});
    }
    wanted.push_back({Target::RowVelocity, k, as_solved(row, row.rate), k});
  }
  for (std::size_t j = 0; j < columns; ++j) {
    const std::size_t group = island.rows.size() + j;
    wanted.push_back({Target::Free, j, derivatives.free[island.speeds[j]], group});
    wanted.push_back({Target::Mobility, j, derivatives.mobility[island.speeds[j]], group});
  }
  return wanted;
}

/// `derivatives` may be those of a correction, of fewer rows than the island has.
IslandPlan plan_solve(std::size_t index, Unknowns unknowns, const std::vector<std::size_t>& rows_of_island,
                      const model::System& system, const Derivatives& derivatives, graph::Graph& graph) {
  const Island& island = derivatives.islands[index];
  IslandPlan plan{index, unknowns, eliminate(island, derivatives, graph), {}, {}};
  for (const std::size_t row : island.rows) {
    plan.floors.push_back(static_cast<std::size_t>(std::find(rows_of_island.begin(), rows_of_island.end(), row) -
                                                   rows_of_island.begin()));
  }
  const Target target = unknowns == Unknowns::Accelerations ? Target::Rate
                        : unknowns == Unknowns::Tangents    ? Target::Change
                                                            : Target::Shift;
  const std::size_t offset = target == Target::Shift ? 0 : system.coordinates.size();
  for (std::size_t j = 0; j < island.speeds.size(); ++j) {
    const std::size_t speed = island.speeds[j];
    plan.solution.push_back({target, offset + speed, plan.elimination.accelerations[j], speed});
  }
  return plan;
}

/// What speeds that no constraint binds have instead of a solve.
std::vector<Wanted> unbound(Target target, const model::System& system, const Derivatives& derivatives) {
  std::vector<bool> in_island(system.speeds.size());
  for (const Island& island : derivatives.islands) {
    for (const std::size_t speed : island.speeds) {
      in_island[speed] = true;
    }
  }
  std::vector<Wanted> wanted;
  for (std::size_t j = 0; j < system.speeds.size(); ++j) {
    if (!in_island[j]) {
      wanted.push_back({target, system.coordinates.size() + j, derivatives.free[j], j});
    }
  }
  return wanted;
}

std::vector<IslandPlan> plan_shifts(mechanics::ErrorLevel level, const model::System& system,
                                    const Derivatives& derivatives, graph::Graph& graph) {
  const Derivatives corrected = corrections(derivatives, system, level, graph);
  const Unknowns unknowns = level == mechanics::ErrorLevel::Position ? Unknowns::Displacements : Unknowns::SpeedChanges;
  std::vector<IslandPlan> plans;
  for (std::size_t i = 0; i < corrected.islands.size(); ++i) {
    if (!corrected.islands[i].rows.empty()) {
      plans.push_back(plan_solve(i, unknowns, derivatives.islands[i].rows, system, corrected, graph));
    }
  }
  return plans;
}

std::vector<Wanted> errors_of(const model::System& system, const Derivatives& derivatives, graph::Graph& graph) {
  std::vector<Wanted> wanted;
  for (const Row& row : derivatives.rows) {
    const std::size_t k = row.constraint;
    if (system.constraints[k].holonomic) {
      wanted.push_back({Target::Position, k, row.value, k});
    }
    wanted.push_back({Target::Velocity, k, row.rate, k});
    Expr acceleration = -row.b;
    for (const Entry& entry : row.entries) {
      const auto speed = static_cast<std::uint32_t>(entry.speed);
      acceleration = acceleration + entry.value * graph.leaf(Kind::Acceleration, speed);
    }
    wanted.push_back({Target::Acceleration, k, acceleration, k});
  }
  return wanted;
}

/// What stands for a displacement or a change along each speed: the leaves of the accelerations.
std::vector<Expr> changes_along_speeds(std::size_t speeds, graph::Graph& graph) {
  std::vector<Expr> changes;
  for (std::uint32_t j = 0; j < speeds; ++j) {
    changes.push_back(graph.leaf(Kind::Acceleration, j));
  }
  return changes;
}

void plan_couplings(Plan& plan, const model::System& system, const Derivatives& derivatives, graph::Graph& graph) {
  const std::vector<Expr> changes = changes_along_speeds(system.speeds.size(), graph);
  const std::vector<Expr> coupled = mechanics::coupled(derivatives.couplings, changes);
  const std::vector<Expr> uncoupled = mechanics::uncoupled(derivatives.couplings, changes);
  for (std::size_t j = 0; j < changes.size(); ++j) {
    if (coupled[j] != changes[j]) {
      plan.couple.push_back({Target::Shift, j, coupled[j], j});
      plan.uncouple.push_back({Target::Shift, j, uncoupled[j], j});
    }
  }
}

/// K u for each coordinate, with a displacement along the speeds in the place of u.
std::vector<Wanted> displacements(const Equations& equations, graph::Graph& graph) {
  const std::vector<Expr> changes = changes_along_speeds(equations.inertia.size(), graph);
  std::vector<Expr> moves;
  for (const Expr rate : equations.kinematics) {
    Expr move = graph.constant(0);
    for (const auto& [speed, direction] : mechanics::partials_along_speeds(rate)) {
      move = move + direction * changes[speed];
    }
    moves.push_back(move);
  }
  return all_of(Target::Shift, moves);
}

void name_solve(Plan& plan, const IslandPlan& island_plan, const Island& island, const model::System& system,
                const Derivatives& derivatives) {
  for (std::size_t k = 0; k < island.rows.size(); ++k) {
    const Row& row = derivatives.rows[island.rows[k]];
    const std::string& constraint = system.constraints[row.constraint].name;
    for (const Entry& entry : row.solved) {
      plan.names.emplace_back(as_solved(row, entry.value),
                              fmt::format("A_{}_{}", constraint, system.speeds[entry.speed].name));
    }
    plan.names.emplace_back(as_solved(row, row.residual), "r_" + constraint);
    plan.names.emplace_back(island_plan.elimination.pivots[k].diagonal, "S_" + constraint);
    plan.names.emplace_back(island_plan.elimination.pivots[k].pivot, "d_" + constraint);
    plan.names.emplace_back(island_plan.elimination.forward[k], "y_" + constraint);
    plan.names.emplace_back(island_plan.elimination.multipliers[k], "z_" + constraint);
  }
}

}  // namespace

namespace {

void add(const std::vector<Wanted>& wanted, std::vector<Expr>& roots) {
  for (const Wanted& item : wanted) {
    roots.push_back(item.value);
  }
}

void add(const IslandPlan& island, std::vector<Expr>& roots) {
  add(island.solution, roots);
  for (const mechanics::Pivot& pivot : island.elimination.pivots) {
    roots.insert(roots.end(), {pivot.diagonal, pivot.pivot, pivot.scale});
  }
  for (const auto* values :
       {&island.elimination.forward, &island.elimination.quotients, &island.elimination.multipliers}) {
    roots.insert(roots.end(), values->begin(), values->end());
  }
  for (const auto* rows :
       {&island.elimination.rows, &island.elimination.couplings, &island.elimination.constraint_terms}) {
    for (const std::vector<Expr>& row : *rows) {
      roots.insert(roots.end(), row.begin(), row.end());
    }
  }
}

}  // namespace

std::vector<Expr> Plan::roots() const {
  std::vector<Expr> roots;
  for (const auto* wanted : {&initial, &kinematics, &free_accelerations, &constraint_errors, &energy, &outputs,
                             &applied_forces, &couple, &uncouple, &move}) {
    add(*wanted, roots);
  }
  for (const std::vector<Wanted>& rows : island_rows) {
    add(rows, roots);
  }
  for (const auto* solves : {&islands, &position_shifts, &velocity_shifts}) {
    for (const IslandPlan& island : *solves) {
      add(island, roots);
    }
  }
  return roots;
}

std::vector<Expr> TangentPlan::roots() const {
  std::vector<Expr> roots;
  add(kinematics, roots);
  add(free_accelerations, roots);
  for (const IslandPlan& island : islands) {
    add(island, roots);
  }
  return roots;
}

TangentPlan plan_tangent(const Plan& plan, const model::System& system, const Equations& equations,
                         const Derivatives& derivatives, graph::Graph& graph) {
  std::vector<const mechanics::Elimination*> solutions;
  for (const IslandPlan& island : plan.islands) {
    solutions.push_back(&island.elimination);
  }
  const mechanics::Tangent tangent = differentiate_along_direction(equations, derivatives, solutions);
  TangentPlan result{
      all_of(Target::Change, tangent.kinematics), unbound(Target::Change, system, tangent.equations), {}};
  for (std::size_t i = 0; i < derivatives.islands.size(); ++i) {
    result.islands.push_back(
        plan_solve(i, Unknowns::Tangents, derivatives.islands[i].rows, system, tangent.equations, graph));
  }
  return result;
}

Plan make_plan(const model::System& system, const Equations& equations, const Derivatives& derivatives,
               graph::Graph& graph) {
  const std::size_t coordinates = system.coordinates.size();
  Plan plan;
  plan.initial = all_of(Target::Initial, equations.initial_coordinates);
  for (const Wanted& speed : all_of(Target::Initial, equations.initial_speeds, coordinates)) {
    plan.initial.push_back(speed);
  }
  plan.kinematics = all_of(Target::Rate, equations.kinematics);
  for (std::size_t i = 0; i < derivatives.islands.size(); ++i) {
    const Island& island = derivatives.islands[i];
    plan.islands.push_back(plan_solve(i, Unknowns::Accelerations, island.rows, system, derivatives, graph));
    plan.island_rows.push_back(rows_of(island, system, derivatives));
    name_solve(plan, plan.islands.back(), island, system, derivatives);
  }
  if (system.integration.chooses_step()) {
    plan.position_shifts = plan_shifts(mechanics::ErrorLevel::Position, system, derivatives, graph);
    plan.velocity_shifts = plan_shifts(mechanics::ErrorLevel::Velocity, system, derivatives, graph);
  }
  plan.free_accelerations = unbound(Target::Rate, system, derivatives);
  plan_couplings(plan, system, derivatives, graph);
  if (!system.moves_plainly() && !derivatives.islands.empty()) {
    plan.move = displacements(equations, graph);
  }
  plan.constraint_errors = errors_of(system, derivatives, graph);
  if (derivatives.energy) {
    plan.energy.push_back({Target::Energy, 0, *derivatives.energy, 0});
  }
  plan.outputs = all_of(Target::Output, equations.outputs);
  plan.applied_forces = all_of(Target::Force, equations.forces);
  return plan;
}

}  // namespace mbcc::program
