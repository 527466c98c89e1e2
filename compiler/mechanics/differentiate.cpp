#include <algorithm>
#include <cmath>

#include "mechanics/collect.hpp"
#include "mechanics/derivatives.hpp"
#include "mechanics/directions.hpp"
#include "mechanics/energies.hpp"
#include "mechanics/islands.hpp"
#include "mechanics/redundancy.hpp"
#include "mechanics/uncouple.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Graph;
using graph::Level;

/// Of a holonomic constraint those of its rate, of a nonholonomic one its own.
std::vector<Entry> entries_of(const Equations& equations, Expr constraint, bool holonomic) {
  std::map<std::size_t, Expr> by_speed;
  if (holonomic) {
    for (const std::uint32_t i : occurring(constraint, Kind::Coordinate)) {
      const Expr slope = partial(constraint, Kind::Coordinate, i);
      for (const auto& [speed, direction] : partials_along_speeds(equations.kinematics[i])) {
        const auto [entry, is_new] = by_speed.try_emplace(speed, slope * direction);
        if (!is_new) {
          entry->second = entry->second + slope * direction;
        }
      }
    }
  } else {
    by_speed = partials_along_speeds(constraint);
  }
  std::vector<Entry> entries;
  for (const auto& [speed, value] : by_speed) {
    if (!is_zero(value)) {
      entries.push_back({speed, value});
    }
  }
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
                             const UnacceleratedMotion& motion) {
  const Expr value = equations.constraints[k];
  const bool holonomic = system.constraints[k].holonomic;
  const UnacceleratedMotion::Rates rates = motion.rates(value);
  const Expr b = collect(holonomic ? -rates.second : -rates.first);
  return {k, entries_of(equations, value, holonomic), {}, b, value, holonomic ? collect(rates.first) : value, b, 1};
}

/// What the row is in uncoupled speeds, where the motion without constraints is `free`.
void finish(Row& row, std::vector<Entry> solved, const std::vector<Expr>& free) {
  row.solved = std::move(solved);
  Expr of_free_motion = number(row.b, 0);
  for (const Entry& entry : row.solved) {
    of_free_motion = of_free_motion + entry.value * free[entry.speed];
  }
  row.residual = collect(row.b - of_free_motion);
  row.content = content_of(row.solved);
}

std::vector<Expr> sum_of_forces(const Equations& equations, Graph& graph) {
  std::vector<Expr> total(equations.inertia.size(), graph.constant(0));
  for (std::size_t i = 0; i < equations.forces.size(); ++i) {
    for (const auto& [speed, direction] : partials_along_speeds(equations.force_velocities[i])) {
      total[speed] = total[speed] + direction * equations.forces[i];
    }
  }
  return total;
}

/// Kinetic and potential energy, less the work of the constant forces; nothing where a force is not constant and the
/// model does not declare what the energy is.
std::optional<Expr> energy_of(const model::System& system, const Equations& equations, const std::vector<Expr>& forces,
                              Graph& graph) {
  const bool declared = !equations.kinetic.empty() || !equations.potential.empty();
  const auto is_constant = [](Expr force) { return force.level() <= Level::Parameter; };
  if (!declared && !std::all_of(forces.begin(), forces.end(), is_constant)) {
    return std::nullopt;
  }
  Expr energy = graph.constant(0);
  for (std::uint32_t j = 0; j < system.speeds.size(); ++j) {
    const Expr speed = graph.leaf(Kind::Speed, j);
    energy = energy + graph.constant(0.5) * equations.inertia[j] * speed * speed;
  }
  for (const Expr kinetic : equations.kinetic) {
    energy = energy + with_rates(kinetic, equations.kinematics);
  }
  for (const Expr potential : equations.potential) {
    energy = energy + potential;
  }
  for (std::uint32_t i = 0; i < system.coordinates.size(); ++i) {
    const std::optional<model::SpeedId> speed = system.speed_of(system.coordinates[i]);
    if (speed && is_constant(forces[model::index(*speed)])) {
      energy = energy - forces[model::index(*speed)] * graph.leaf(Kind::Coordinate, i);
    }
  }
  return energy;
}

/// Speeds that no constraint touches need no solve: they get their own accelerations at once.
void release_unconstrained(Derivatives& derivatives) {
  std::vector<bool> constrained(derivatives.free.size());
  for (const Island& island : derivatives.islands) {
    for (const std::size_t speed : island.speeds) {
      constrained[speed] = true;
    }
  }
  const std::vector<Expr> accelerations = coupled(derivatives.couplings, derivatives.free);
  for (std::size_t j = 0; j < constrained.size(); ++j) {
    if (!constrained[j]) {
      derivatives.free[j] = accelerations[j];
    }
  }
  std::erase_if(derivatives.couplings, [&](const Coupling& coupling) { return !constrained[coupling.speed]; });
}

}  // namespace

std::optional<std::size_t> find_changing_inertia(const Derivatives& derivatives) {
  const auto changes = [](Expr value) { return value.level() > Level::Parameter; };
  for (const Island& island : derivatives.islands) {
    for (const std::size_t speed : island.speeds) {
      if (changes(derivatives.mobility[speed])) {
        return speed;
      }
    }
  }
  for (const Coupling& coupling : derivatives.couplings) {
    if (std::any_of(coupling.terms.begin(), coupling.terms.end(),
                    [&](const Entry& term) { return changes(term.value); })) {
      return coupling.speed;
    }
  }
  return std::nullopt;
}

Derivatives differentiate(const model::System& system, const Equations& equations, Graph& graph) {
  Derivatives derivatives;
  const std::vector<Expr> applied = sum_of_forces(equations, graph);
  EnergyTerms energies = differentiate_energies(equations, graph);
  for (std::size_t j = 0; j < applied.size(); ++j) {
    energies.forces[j] = energies.forces[j] + applied[j];
  }
  const UnacceleratedMotion motion(equations.kinematics);
  for (std::size_t k = 0; k < equations.constraints.size(); ++k) {
    derivatives.rows.push_back(differentiate_constraint(system, equations, k, motion));
  }
  Uncoupled uncoupled = uncouple(energies.inertia, energies.forces, derivatives.rows, initial_point(system, equations));
  for (std::size_t j = 0; j < energies.inertia.size(); ++j) {
    const auto diagonal = energies.inertia[j].find(j);
    derivatives.inertia.push_back(diagonal == energies.inertia[j].end() ? graph.constant(1) : diagonal->second);
  }
  derivatives.free = std::move(uncoupled.free);
  derivatives.couplings = std::move(uncoupled.couplings);
  derivatives.undetermined = std::move(uncoupled.undetermined);
  for (const Expr inertia : uncoupled.inertia) {
    derivatives.mobility.push_back(graph.constant(1) / inertia);
  }
  for (std::size_t k = 0; k < derivatives.rows.size(); ++k) {
    finish(derivatives.rows[k], std::move(uncoupled.rows[k]), derivatives.free);
  }
  derivatives.islands = find_islands(derivatives.rows, derivatives.couplings, system.speeds.size());
  release_unconstrained(derivatives);
  for (Island& island : derivatives.islands) {
    island.held = find_implied_rows(island, system, equations, derivatives);
    std::erase_if(island.rows, [&](std::size_t row) {
      return std::find(island.held.begin(), island.held.end(), row) != island.held.end();
    });
    island.rows = elimination_order(derivatives.rows, island.rows);
  }
  derivatives.energy = energy_of(system, equations, applied, graph);
  return derivatives;
}

}  // namespace mbcc::mechanics
