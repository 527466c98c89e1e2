#include "page/thin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mbcc::page {

namespace {

using Columns = std::vector<std::vector<double>>;

/// 1 / (largest - smallest finite value), 0 for a column that is constant.
std::vector<double> weights(const Columns& columns) {
  std::vector<double> result;
  for (const std::vector<double>& column : columns) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : column) {
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
    result.push_back(high > low ? 1 / (high - low) : 0);
  }
  return result;
}

/// The row between `begin` and `end` that the line between these two misses most; `begin` if it misses none.
std::size_t farthest_row(const Columns& columns, const std::vector<double>& weight, std::size_t begin,
                         std::size_t end) {
  std::size_t farthest = begin;
  double most = 0;
  const double span = columns[0][end] - columns[0][begin];
  for (std::size_t i = 1; i < columns.size(); ++i) {
    const std::vector<double>& column = columns[i];
    for (std::size_t row = begin + 1; row < end && weight[i] > 0; ++row) {
      const double along = span > 0 ? (columns[0][row] - columns[0][begin]) / span : 0;
      const double line = column[begin] + along * (column[end] - column[begin]);
      const double distance = weight[i] * std::abs(column[row] - line);
      if (distance > most) {
        most = distance;
        farthest = row;
      }
    }
  }
  return farthest;
}

}  // namespace

std::vector<std::size_t> thin(const Columns& columns, std::size_t wanted) {
  const std::size_t rows = columns.front().size();
  std::vector<std::size_t> kept;
  if (rows <= wanted) {
    kept.resize(rows);
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    return kept;
  }
  const std::vector<double> weight = weights(columns);
  const std::size_t stretches = std::max<std::size_t>(wanted / 2, 1);
  for (std::size_t i = 0; i < stretches; ++i) {
    const std::size_t begin = i * (rows - 1) / stretches;
    const std::size_t end = (i + 1) * (rows - 1) / stretches;
    kept.push_back(begin);
    if (const std::size_t row = farthest_row(columns, weight, begin, end); row != begin) {
      kept.push_back(row);
    }
  }
  kept.push_back(rows - 1);
  return kept;
}

}  // namespace mbcc::page
