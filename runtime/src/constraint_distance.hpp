#pragma once
// How far a state is from satisfying a constraint, in units of the state.

#include <algorithm>
#include <cmath>
#include <span>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// Largest absolute value, at least 1: what distances in coordinates or in speeds are compared to.
inline double extent(std::span<const double> values) {
  double largest = 1;
  for (const double value : values) {
    largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// |A_k| of one of the rows that an island holds.
inline double row_norm(const IslandRows& rows, std::size_t row) {
  const std::size_t columns = rows.mobility.size();
  double square = 0;
  for (const double entry : rows.matrix.subspan(row * columns, columns)) {
    square += entry * entry;
  }
  return std::sqrt(square);
}

/// |error| / |A_k|: to first order the shortest way to where the constraint, or its rate, is zero.
inline double distance(double error, double norm) { return error == 0 ? 0 : std::abs(error) / norm; }

}  // namespace mbrt
