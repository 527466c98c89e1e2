#pragma once
// Which rows of an island depend on the others, numerically, at one point.

#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/point.hpp"

namespace mbcc::mechanics {

/// Singular values of the scaled rows below this count as zero (mbrt::default_cutoff).
inline constexpr double rank_cutoff = 1e-8;

/// row = sum of coefficient * (an earlier, independent row), as rows of A.
struct Dependence {
  std::size_t row;
  std::vector<std::pair<std::size_t, double>> on;  ///< nonzero coefficients by row
  double growth = 0;                               ///< the largest of them between rows of size 1
};

/// All rows of the island, the held ones too, are taken in the order of the model, so that it is the later one of two
/// equal rows that depends on the earlier. Rows are scaled to size 1 first; a row that is zero depends on nothing and
/// is listed with empty `on`.
std::vector<Dependence> find_dependences(const Island& island, const Derivatives& derivatives, const Point& point);

}  // namespace mbcc::mechanics
