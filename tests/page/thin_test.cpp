#include "page/thin.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

namespace mbcc::page {
namespace {

using Columns = std::vector<std::vector<double>>;

/// Time, a slow wave, and zeros; with one value of the last column set.
Columns quiet_with_peak(std::size_t rows, std::size_t at, double peak) {
  Columns columns(3, std::vector<double>(rows));
  for (std::size_t row = 0; row < rows; ++row) {
    columns[0][row] = 0.01 * static_cast<double>(row);
    columns[1][row] = std::sin(columns[0][row]);
  }
  columns[2][at] = peak;
  return columns;
}

bool contains(const std::vector<std::size_t>& rows, std::size_t row) {
  return std::find(rows.begin(), rows.end(), row) != rows.end();
}

}  // namespace

TEST_CASE("a result that is short enough keeps all its rows") {
  CHECK(thin(quiet_with_peak(4, 1, 1), 4) == std::vector<std::size_t>{0, 1, 2, 3});
  CHECK(thin({{0.0}}, 10) == std::vector<std::size_t>{0});
}

TEST_CASE("a long result keeps its ends, its order and any peak") {
  const std::size_t at = GENERATE(1U, 4999U, 7777U, 9998U);
  const double peak = GENERATE(1.0, -1e-12);  // small beside the other column, but not in its own
  const std::vector<std::size_t> rows = thin(quiet_with_peak(10000, at, peak), 100);
  CHECK(rows.front() == 0);
  CHECK(rows.back() == 9999);
  CHECK(std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end());
  CHECK(rows.size() > 60);
  CHECK(rows.size() <= 101);
  CHECK(contains(rows, at));
}

TEST_CASE("values that are not numbers do not decide which rows are kept") {
  Columns columns = quiet_with_peak(1000, 500, 1);
  columns[1].assign(1000, std::numeric_limits<double>::quiet_NaN());
  CHECK(contains(thin(columns, 20), 500));
}

}  // namespace mbcc::page
