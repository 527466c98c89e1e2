#include <algorithm>
#include <cmath>

#include "constraint_distance.hpp"
#include "correction.hpp"

namespace mbrt {

double extent(std::span<const double> values) {
  double largest = 1;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

void climb_off(const Island& island, double relative_distance, std::span<double> added) {
  const IslandRecord kept = *island.record;
  island.record->cutoff = std::clamp(relative_distance, kept.cutoff, std::max(kept.cutoff, largest_cutoff));
  climb(island, added);
  *island.record = kept;
}

void correct(const Island& island, std::span<const double> errors, double size, std::span<double> added) {
  double farthest = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    farthest = std::max(farthest, distance(errors[i], row_norm(island.rows, i)));
    island.rows.residual[i] = -errors[i];
  }
  climb_off(island, farthest / size, added);
}

}  // namespace mbrt
