#pragma once
// What the emitted class has to compute, as expressions: the step between the mathematics and the kernels.

#include <string>
#include <utility>
#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/eliminate.hpp"
#include "model/system.hpp"
#include "program/program.hpp"

namespace mbcc::program {

/// A value to be stored by a kernel. Neighbours of one group form a unit.
struct Wanted {
  Target target;
  std::size_t index;
  graph::Expr value;
  std::size_t group;
};

struct IslandPlan {
  std::size_t island;
  Unknowns unknowns;
  mechanics::Elimination elimination;
  std::vector<std::size_t> floors;  ///< by pivot: the row of the island whose floor it must keep
  std::vector<Wanted> solution;     ///< Rate, Change or Shift of the island's speeds when the plain solve holds
};

struct Plan {
  std::vector<Wanted> initial;
  std::vector<Wanted> kinematics;          ///< Rate of coordinates
  std::vector<Wanted> free_accelerations;  ///< Rate of speeds in no island
  std::vector<IslandPlan> islands;
  std::vector<std::vector<Wanted>> island_rows;  ///< Matrix, Residual, Free, Mobility, errors: by island
  std::vector<IslandPlan> position_shifts;       ///< of islands with holonomic rows
  std::vector<IslandPlan> velocity_shifts;
  std::vector<Wanted> couple;    ///< Shift of speeds that others' inertia couples
  std::vector<Wanted> uncouple;  ///< likewise, the other way round
  std::vector<Wanted> move;      ///< Shift of coordinates, where it is not that of the speeds
  std::vector<Wanted> constraint_errors;
  std::vector<Wanted> energy;
  std::vector<Wanted> outputs;
  std::vector<Wanted> applied_forces;
  std::vector<std::pair<graph::Expr, std::string>> names;  ///< first come, first named

  std::vector<graph::Expr> roots() const;
};

/// Derivatives of the rates along a direction: Note [tangent] in mechanics/tangent.hpp.
struct TangentPlan {
  std::vector<Wanted> kinematics;          ///< Change of coordinates
  std::vector<Wanted> free_accelerations;  ///< Change of speeds in no island
  std::vector<IslandPlan> islands;

  std::vector<graph::Expr> roots() const;
};

TangentPlan plan_tangent(const Plan& plan, const model::System& system, const mechanics::Equations& equations,
                         const mechanics::Derivatives& derivatives, graph::Graph& graph);

Plan make_plan(const model::System& system, const mechanics::Equations& equations,
               const mechanics::Derivatives& derivatives, graph::Graph& graph);

}  // namespace mbcc::program
