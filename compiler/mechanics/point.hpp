#pragma once
// Expressions as numbers, at one point of a model's state space.

#include <vector>

#include "mechanics/equations.hpp"

namespace mbcc::mechanics {

struct Point {
  double time = 0;
  std::vector<double> parameters;
  std::vector<double> coordinates;
  std::vector<double> speeds;
};

/// The start of a run at the parameters' default values.
Point initial_point(const model::System& system, const Equations& equations);

/// Values of `expressions` at `point`; an Acceleration leaf is zero.
std::vector<double> values_at(const Point& point, const std::vector<Expr>& expressions);
double value_at(const Point& point, Expr expression);

}  // namespace mbcc::mechanics
