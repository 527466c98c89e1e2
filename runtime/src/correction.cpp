#include "correction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraint_distance.hpp"

namespace mbrt {

namespace {

/// A speed that alone would change something held gets no mobility.
void hold_single_speeds(const IslandRows& rows, const std::vector<std::vector<double>>& directions) {
  for (const std::vector<double>& direction : directions) {
    if (std::count(direction.begin(), direction.end(), 0.0) + 1 == static_cast<std::ptrdiff_t>(direction.size())) {
      const auto moving = std::find_if(direction.begin(), direction.end(), [](double part) { return part != 0; });
      rows.mobility[static_cast<std::size_t>(moving - direction.begin())] = 0;
    }
  }
}

/// Takes out of the rows what would change something held, so that the shortest displacement leaves it as it is.
/// Directions are made orthogonal by mass first; one that depends on others has nothing left.
void hold(const IslandRows& rows, std::vector<std::vector<double>> directions) {
  constexpr double nothing = 1e-24;  // squares of what rounding leaves of a direction
  hold_single_speeds(rows, directions);
  const std::size_t columns = rows.mobility.size();
  const auto product = [&](std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      sum += a[j] * rows.mobility[j] * b[j];
    }
    return sum;
  };
  const auto take_out = [&](std::span<double> from, std::span<const double> direction, double square) {
    const double factor = product(from, direction) / square;
    for (std::size_t j = 0; j < columns; ++j) {
      from[j] -= factor * direction[j];
    }
  };
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double before = product(directions[k], directions[k]);
    for (std::size_t l = 0; l < k; ++l) {
      if (const double square = product(directions[l], directions[l]); square > 0) {
        take_out(directions[k], directions[l], square);
      }
    }
    const double square = product(directions[k], directions[k]);
    if (!(square > nothing * before)) {
      std::fill(directions[k].begin(), directions[k].end(), 0.0);
      continue;
    }
    for (std::size_t i = 0; i < rows.residual.size(); ++i) {
      take_out(rows.matrix.subspan(i * columns, columns), directions[k], square);
    }
  }
}

}  // namespace

Correction::Correction(AnyModel& model, const std::vector<Island>& islands)
    : model_(model),
      description_(model.description()),
      islands_(islands),
      step_(description_.speeds.size()),
      rate_(description_.coordinates.size() + step_.size()),
      uncoupled_(step_.size()),
      moved_(description_.coordinates.size()) {
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

void Correction::fill_rate(std::span<const double> along_speeds) {
  std::copy(along_speeds.begin(), along_speeds.end(),
            rate_.begin() + static_cast<std::ptrdiff_t>(description_.coordinates.size()));
}

std::span<const double> Correction::step(const ErrorTerms& terms, std::span<const double> state,
                                         std::span<const double> moved, const std::vector<bool>& held) {
  const std::size_t coordinates = description_.coordinates.size();
  const double size = extent(terms.velocity == 0 ? state.first(coordinates) : state.subspan(coordinates));
  if (!moved.empty()) {
    fill_rate(moved);
    model_.uncouple(state, rate_, uncoupled_);
  }
  for (std::size_t k = 0; k < islands_.size(); ++k) {
    const std::vector<std::vector<double>> directions =
        held.empty() ? std::vector<std::vector<double>>() : held_directions(terms, k, state, held);
    model_.island_rows(static_cast<int>(k), state);
    const double distance_off =
        fill_residuals(terms, k, moved.empty() ? std::span<const double>() : std::span<const double>(uncoupled_));
    hold(islands_[k].rows, directions);
    solve(k, distance_off / size);
  }
  fill_rate(step_);
  model_.couple(state, rate_, step_);
  return step_;
}

std::span<const double> Correction::coordinates_of(std::span<const double> state,
                                                   std::span<const double> along_speeds) {
  fill_rate(along_speeds);
  model_.move(state, rate_, moved_);
  return moved_;
}

/// What each held element changes by with the island's uncoupled speeds.
std::vector<std::vector<double>> Correction::held_directions(const ErrorTerms& terms, std::size_t island,
                                                             std::span<const double> state,
                                                             const std::vector<bool>& held) {
  const std::span<const int> speeds = description_.islands[island].speeds;
  std::vector<std::vector<double>> directions(held.size(), std::vector<double>(speeds.size()));
  std::vector<double> unit(description_.speeds.size()), coupled(unit);
  for (std::size_t c = 0; c < speeds.size(); ++c) {
    unit.assign(unit.size(), 0.0);
    unit[static_cast<std::size_t>(speeds[c])] = 1;
    fill_rate(unit);
    model_.couple(state, rate_, coupled);
    const std::span<const double> change =
        terms.velocity == 0 ? coordinates_of(state, coupled) : std::span<const double>(coupled);
    for (std::size_t i = 0; i < held.size(); ++i) {
      directions[i][c] = held[i] ? change[i] : 0;
    }
  }
  std::erase_if(directions, [](const std::vector<double>& direction) {
    return std::all_of(direction.begin(), direction.end(), [](double part) { return part == 0; });
  });
  return directions;
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

void Correction::solve(std::size_t island, double relative_distance) {
  const Island& solved = islands_[island];
  const std::span<const int> speeds = description_.islands[island].speeds;
  climb_off(solved, relative_distance, std::span(added_).first(speeds.size()));
  for (std::size_t j = 0; j < speeds.size(); ++j) {
    step_[static_cast<std::size_t>(speeds[j])] = added_[j];
  }
}

}  // namespace mbrt
