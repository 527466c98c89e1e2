#include "mechanics/print.hpp"

#include <fmt/format.h>

namespace mbcc {

namespace mechanics {

namespace {

using Labelled = std::vector<std::pair<std::string, Expr>>;

std::string section(std::string_view title, const Labelled& labelled, const model::System& system) {
  return labelled.empty() ? "" : fmt::format("{}\n{}\n", title, graph::print(labelled, leaf_names(system)));
}

}  // namespace

graph::LeafName leaf_names(const model::System& system) {
  return [&system](const graph::Node& node) -> std::string {
    switch (node.kind) {
      case graph::Kind::Coordinate:
        return system.coordinates[node.index].name;
      case graph::Kind::Speed:
        return system.speeds[node.index].name;
      case graph::Kind::CoordinateRate:
        return system.coordinates[node.index].name + "'";
      case graph::Kind::CoordinateChange:
        return "d " + system.coordinates[node.index].name;
      case graph::Kind::SpeedChange:
        return "d " + system.speeds[node.index].name;
      case graph::Kind::Acceleration:
        return system.speeds[node.index].acceleration;
      case graph::Kind::Parameter:
        return system.parameters[node.index].name;
      default:
        return "t";
    }
  };
}

}  // namespace mechanics

std::string print(const mechanics::Equations& equations, const model::System& system) {
  using namespace mechanics;
  Labelled start, kinematics, inertia, energies, forces, constraints, outputs;
  for (std::size_t i = 0; i < system.coordinates.size(); ++i) {
    const std::string& name = system.coordinates[i].name;
    start.emplace_back(name, equations.initial_coordinates[i]);
    kinematics.emplace_back(name + "'", equations.kinematics[i]);
  }
  for (std::size_t j = 0; j < system.speeds.size(); ++j) {
    start.emplace_back(system.speeds[j].name, equations.initial_speeds[j]);
    if (!is_zero(equations.inertia[j])) {
      inertia.emplace_back(system.speeds[j].name, equations.inertia[j]);
    }
  }
  for (std::size_t i = 0; i < equations.kinetic.size(); ++i) {
    energies.emplace_back(fmt::format("kinetic {}", i + 1), equations.kinetic[i]);
  }
  for (std::size_t i = 0; i < equations.potential.size(); ++i) {
    energies.emplace_back(fmt::format("potential {}", i + 1), equations.potential[i]);
  }
  for (std::size_t i = 0; i < system.forces.size(); ++i) {
    const model::Force& force = system.forces[i];
    const model::Expression& along = system[force.along];
    const bool is_along_speed = along.kind == model::ExpressionKind::Speed;
    forces.emplace_back(
        is_along_speed ? fmt::format("{} [{}]", system.speeds[along.index].name, force.name) : force.name,
        equations.forces[i]);
  }
  for (std::size_t k = 0; k < system.constraints.size(); ++k) {
    const model::Constraint& constraint = system.constraints[k];
    constraints.emplace_back(
        fmt::format("{} ({})", constraint.name, constraint.holonomic ? "holonomic" : "nonholonomic"),
        equations.constraints[k]);
  }
  for (std::size_t i = 0; i < system.outputs.size(); ++i) {
    outputs.emplace_back(system.outputs[i].name, equations.outputs[i]);
  }
  return section("start", start, system) + section("kinematics", kinematics, system) +
         section("inertia", inertia, system) + section("energies", energies, system) +
         section("forces", forces, system) + section("constraints", constraints, system) +
         section("outputs", outputs, system);
}

std::string print(const mechanics::Derivatives& derivatives, const model::System& system) {
  using namespace mechanics;
  Labelled free, couplings, rows, energy;
  for (std::size_t j = 0; j < system.speeds.size(); ++j) {
    free.emplace_back(system.speeds[j].acceleration, derivatives.free[j]);
  }
  for (const Coupling& coupling : derivatives.couplings) {
    for (const Entry& term : coupling.terms) {
      couplings.emplace_back(
          fmt::format("L[{}, {}]", system.speeds[term.speed].name, system.speeds[coupling.speed].name), term.value);
    }
  }
  for (const Row& row : derivatives.rows) {
    const std::string& name = system.constraints[row.constraint].name;
    for (const Entry& entry : row.entries) {
      rows.emplace_back(fmt::format("A[{}, {}]", name, system.speeds[entry.speed].acceleration), entry.value);
    }
    rows.emplace_back(fmt::format("b[{}]", name), row.b);
  }
  if (derivatives.energy) {
    energy.emplace_back("energy", *derivatives.energy);
  }
  std::string islands = derivatives.islands.empty() ? "" : "islands, rows in elimination order\n";
  for (const Island& island : derivatives.islands) {
    for (const std::size_t row : island.rows) {
      islands += system.constraints[row].name + " ";
    }
    islands += "|";
    for (const std::size_t speed : island.speeds) {
      islands += " " + system.speeds[speed].name;
    }
    islands += "\n";
  }
  return section("free accelerations", free, system) + section("couplings", couplings, system) +
         section("rows of A u' = b", rows, system) + section("energy", energy, system) + islands;
}

}  // namespace mbcc
