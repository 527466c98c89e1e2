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

/// |A_k (u' - a) - r_k| of one row.
double residual_of(const IslandRows& rows, std::size_t row, std::span<const int> speeds,
                   std::span<const double> acceleration) {
  const std::size_t columns = rows.mobility.size();
  double sum = -rows.residual[row];
  for (std::size_t j = 0; j < columns; ++j) {
    sum += rows.matrix[row * columns + j] * (acceleration[static_cast<std::size_t>(speeds[j])] - rows.free[j]);
  }
  return std::abs(sum);
}

/// |A_k u' - b_k| of each row of an island in parts of its terms.
std::vector<double> relative_residuals(AnyModel& model, const Island& island, int k, std::span<const double> state,
                                       std::span<const double> rate) {
  const Description& description = model.description();
  const IslandEntry& entry = description.islands[static_cast<std::size_t>(k)];
  const Extents size = extents(description, state);
  std::vector<double> acceleration(description.speeds.size());
  model.uncouple(state, rate, acceleration);
  model.island_rows(k, state);
  std::vector<double> result;
  for (std::size_t row = 0; row < entry.constraints.size(); ++row) {
    const double residual = residual_of(island.rows, row, entry.speeds, acceleration);
    result.push_back(residual == 0 ? 0 : residual / size_of_terms(island.rows, row, entry.speeds, acceleration, size));
  }
  return result;
}

/// The size of the smallest displacement that the rows of an island turn into one kind of their errors, as far as they
/// can.
double displacement(AnyModel& model, const Island& island, int k, std::span<const double> state,
                    std::span<double> IslandRows::*errors) {
  model.island_rows(k, state);
  const std::span<const double> off = island.rows.*errors;
  std::copy(off.begin(), off.end(), island.rows.residual.begin());
  std::vector<double> displaced(island.rows.mobility.size());
  climb(island, displaced);
  double largest = 0;
  for (const double value : displaced) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

}  // namespace

std::string explain_not_finite(AnyModel& model, const std::vector<Island>& islands, double time,
                               std::span<const double> state) {
  const Description& description = model.description();
  constexpr double beyond_physics = 1e100;  // what follows overflows where such numbers are multiplied
  if (!(extent(state) < beyond_physics) || !all_finite(state)) {
    return fmt::format("error: the motion grows without bound before t = {:.9g}", time);
  }
  std::vector<double> forces(description.forces.size());
  model.applied_forces(state, forces);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!std::isfinite(forces[i])) {
      return fmt::format("{}: error: {} is not a finite number at t = {:.9g}", description.forces[i].place,
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
        return fmt::format("{}: error: the derivatives of constraint `{}` are not finite numbers at t = {:.9g}",
                           entry.place, entry.name, time);
      }
    }
  }
  return fmt::format("error: the acceleration is not a finite number at t = {:.9g}", time);
}

std::string find_contradiction(AnyModel& model, const Island& island, int k, double time, std::span<const double> state,
                               std::span<const double> rate, std::span<const double> residuals) {
  constexpr double rounding = 1e-6;
  constexpr double degree = 10;
  const std::vector<double> relative = relative_residuals(model, island, k, state, rate);
  if (*std::max_element(relative.begin(), relative.end()) <= rounding) {
    return {};
  }
  const Description& description = model.description();
  const Extents size = extents(description, state);
  const double drift = std::max(displacement(model, island, k, state, &IslandRows::position) / size.coordinates,
                                displacement(model, island, k, state, &IslandRows::velocity) / size.speeds);
  std::string names, place;
  for (std::size_t row = 0; row < relative.size(); ++row) {
    if (relative[row] > std::max(rounding, degree * drift)) {
      const auto index = static_cast<std::size_t>(description.islands[static_cast<std::size_t>(k)].constraints[row]);
      const ConstraintEntry& constraint = description.constraints[index];
      place = place.empty() ? constraint.place : place;
      names += fmt::format("{}`{}` ({}, residual {:.3g})", names.empty() ? "" : ", ", constraint.name, constraint.place,
                           residuals[index]);
    }
  }
  return names.empty()
             ? names
             : fmt::format("{}: error: no acceleration satisfies these constraints together at t = {:.9g}: {}", place,
                           time, names);
}

}  // namespace mbrt
