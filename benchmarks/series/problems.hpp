#pragma once
// Motions with reference end states, computed in 113 bits by extrapolation (Gragg, Bulirsch, Stoer) at two settings
// that agree to 1e-22 or better; Kepler's by his equation.

#include <span>

namespace bench::series {

struct Problem {
  const char* name;
  const char* model;
  double to;                    ///< from 0
  std::span<const double> end;  ///< coordinates, then speeds
};

std::span<const Problem> problems();

}  // namespace bench::series
