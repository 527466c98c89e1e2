#include "failures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "constraint_distance.hpp"
#include "mbrt/math.hpp"

namespace mbrt {
namespace {

/// Sizes of the state that rows are compared to.
struct Extents {
  double coordinates;
  double speeds;
};

Extents extents(const Description& model, std::span<const double> state) {
  return {extent(state.first(model.coordinates.size())), extent(state.subspan(model.coordinates.size()))};
}

/// The size of the terms of one row, Note [contradiction].
double size_of_terms(const IslandRows& rows, std::size_t row, std::span<const int> speeds,
                     std::span<const double> acceleration, const Extents& size) {
  const std::size_t columns = rows.mobility.size();
  double right_side = rows.residual[row];
  double sum = row_norm(rows, row) * size.speeds * size.speeds / size.coordinates;
  for (std::size_t j = 0; j < columns; ++j) {
    const double entry = rows.matrix[row * columns + j];
    const double added = acceleration[static_cast<std::size_t>(speeds[j])] - rows.free[j];
    right_side += entry * rows.free[j];
    sum += std::abs(entry) * (std::abs(rows.free[j]) + std::abs(added));
  }
  return sum + std::abs(right_side);
}

/// The relative distance d of Note [contradiction], over all rows of an island.
double drift(const Description& model, const IslandRows& rows, int k, const Extents& size,
             const ConstraintErrors& errors) {
  double largest = 0;
  std::size_t row = 0;
  for (const int constraint : model.islands[static_cast<std::size_t>(k)].constraints) {
    const auto index = static_cast<std::size_t>(constraint);
    const double norm = row_norm(rows, row++);
    largest = std::max({largest, distance(errors.position[index], norm) / size.coordinates,
                        distance(errors.velocity[index], norm) / size.speeds});
  }
  return largest;
}

}  // namespace

std::string explain_not_finite(AnyModel& model, const std::vector<Island>& islands, double time,
                               std::span<const double> state) {
  const Description& description = model.description();
  if (!all_finite(state)) {
    return fmt::format("error: the motion grows without bound before t = {}", time);
  }
  std::vector<double> forces(description.forces.size());
  model.applied_forces(state, forces);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!std::isfinite(forces[i])) {
      return fmt::format("{}: error: the force `{}` is not a finite number at t = {}", description.forces[i].place,
                         description.forces[i].name, time);
    }
  }
  for (std::size_t k = 0; k < islands.size(); ++k) {
    const IslandRows& rows = islands[k].rows;
    const std::size_t columns = rows.mobility.size();
    model.island_rows(static_cast<int>(k), state);
    for (std::size_t row = 0; row < rows.residual.size(); ++row) {
      if (!std::isfinite(rows.residual[row]) || !all_finite(rows.matrix.subspan(row * columns, columns))) {
        const auto index = static_cast<std::size_t>(description.islands[k].constraints[row]);
        const ConstraintEntry& entry = description.constraints[index];
        return fmt::format("{}: error: the derivatives of constraint `{}` are not finite numbers at t = {}",
                           entry.place, entry.name, time);
      }
    }
  }
  return fmt::format("error: the acceleration is not a finite number at t = {}", time);
}

std::string find_contradiction(AnyModel& model, const Island& island, int k, double time, std::span<const double> state,
                               std::span<const double> rate, const ConstraintErrors& errors) {
  constexpr double rounding = 1e-6;
  constexpr double degree = 10;
  constexpr double beyond_doubt = 0.1;
  const Description& description = model.description();
  const IslandEntry& entry = description.islands[static_cast<std::size_t>(k)];
  const Extents size = extents(description, state);
  model.island_rows(k, state);
  const double threshold =
      std::clamp(degree * drift(description, island.rows, k, size, errors), rounding, beyond_doubt);
  std::string names, place;
  double worst = 0;
  for (std::size_t row = 0; row < entry.constraints.size(); ++row) {
    const auto index = static_cast<std::size_t>(entry.constraints[row]);
    const double terms =
        size_of_terms(island.rows, row, entry.speeds, rate.subspan(description.coordinates.size()), size);
    const double residual = std::abs(errors.acceleration[index]);
    if (residual > threshold * terms) {
      const ConstraintEntry& constraint = description.constraints[index];
      place = place.empty() ? constraint.place : place;
      names += fmt::format("{}`{}` ({})", names.empty() ? "" : ", ", constraint.name, constraint.place);
      worst = std::max(worst, residual);
    }
  }
  if (names.empty()) {
    return {};
  }
  return fmt::format("{}: error: no acceleration satisfies these constraints together at t = {}: {}; residual {:.3g}",
                     place, time, names, worst);
}

}  // namespace mbrt
