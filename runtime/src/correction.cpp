#include "correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint_distance.hpp"

namespace mbrt {

Correction::Correction(AnyModel& model, const std::vector<Island>& islands)
    : model_(model), description_(model.description()), islands_(islands), step_(description_.speeds.size()) {
  std::size_t widest = 0;
  for (const Island& island : islands_) {
    widest = std::max(widest, island.rows.mobility.size());
  }
  added_.resize(widest);
}

bool Correction::counts(const ErrorTerms& terms, std::size_t island, std::size_t row) const {
  const auto constraint = static_cast<std::size_t>(description_.islands[island].constraints[row]);
  return description_.constraints[constraint].holonomic || terms.nonholonomic != 0;
}

double Correction::error(const ErrorTerms& terms, std::size_t island, std::size_t row) const {
  const auto constraint = static_cast<std::size_t>(description_.islands[island].constraints[row]);
  const IslandRows& rows = islands_[island].rows;
  return description_.constraints[constraint].holonomic
             ? terms.position * rows.position[row] + terms.velocity * rows.velocity[row]
             : terms.nonholonomic * rows.velocity[row];
}

double Correction::size(const ErrorTerms& terms, std::span<const double> state) {
  double sum = 0;
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    model_.island_rows(static_cast<int>(k), state);
    for (std::size_t row = 0; row < islands_[k].scale.size(); ++row) {
      const double scaled = islands_[k].scale[row] * error(terms, k, row);
      sum += scaled * scaled;
    }
  }
  return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
}

std::span<const double> Correction::step(const ErrorTerms& terms, std::span<const double> state,
                                         std::span<const double> moved, const std::vector<bool>& held) {
  const std::size_t coordinates = description_.coordinates.size();
  const double size = extent(terms.velocity == 0 ? state.first(coordinates) : state.subspan(coordinates));
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    model_.island_rows(static_cast<int>(k), state);
    const double distance_off = fill_residuals(terms, k, moved);
    solve(k, distance_off / size, held);
  }
  return step_;
}

/// Returns how far the state is from the farthest constraint.
double Correction::fill_residuals(const ErrorTerms& terms, std::size_t island, std::span<const double> moved) {
  const IslandRows& rows = islands_[island].rows;
  const std::span<const int> speeds = description_.islands[island].speeds;
  const std::size_t columns = rows.mobility.size();
  double farthest = 0;
  for (std::size_t i = 0; i < rows.residual.size(); ++i) {
    const std::span<double> row = rows.matrix.subspan(i * columns, columns);
    if (!counts(terms, island, i)) {
      rows.ignore(i);
    }
    const double off = error(terms, island, i);
    farthest = std::max(farthest, distance(off, row_norm(rows, i)));
    rows.residual[i] = -off;
    for (std::size_t j = 0; j < columns && !moved.empty(); ++j) {
      rows.residual[i] += row[j] * moved[static_cast<std::size_t>(speeds[j])];
    }
  }
  return farthest;
}

void Correction::solve(std::size_t island, double relative_distance, const std::vector<bool>& held) {
  const Island& solved = islands_[island];
  const std::span<const int> speeds = description_.islands[island].speeds;
  for (std::size_t j = 0; j < speeds.size() && !held.empty(); ++j) {
    if (held[static_cast<std::size_t>(speeds[j])]) {
      solved.rows.mobility[j] = 0;
    }
  }
  climb_off(solved, relative_distance, std::span(added_).first(speeds.size()));
  for (std::size_t j = 0; j < speeds.size(); ++j) {
    step_[static_cast<std::size_t>(speeds[j])] = added_[j];
  }
}

}  // namespace mbrt
