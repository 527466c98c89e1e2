#pragma once
// How far a state is from satisfying a constraint, in units of the state.

#include <cmath>
#include <span>

#include "mbrt/island.hpp"

namespace mbrt {

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
