// mbcc-compare REFERENCE.csv RESULT.csv TOLERANCE: does a trajectory agree with its reference?
//
// The measure is the largest |d| / max(1, max|column of the reference|) over the columns that both tables have. Rows
// are matched by `t`; the result may have more of them, not fewer. Exit code 0: agrees; 1: does not; 2: cannot tell.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <stdexcept>

#include "table.hpp"

namespace mbcc::compare {
namespace {

/// Two programs may round their sampling times differently. Far below any step; and a shift by so much that it matters
/// shows in the columns themselves.
constexpr double time_tolerance = 1e-9;

struct SharedColumn {
  std::size_t in_reference;
  std::size_t in_result;
  double scale;
};

std::size_t time_column(const Table& table, const std::string& path) {
  const std::size_t time = column(table, "t");
  if (time == table.names.size()) {
    throw std::runtime_error(path + ": has no column `t`");
  }
  return time;
}

std::vector<SharedColumn> shared_columns(const Table& reference, const Table& result) {
  std::vector<SharedColumn> shared;
  for (std::size_t i = 0; i < reference.names.size(); ++i) {
    const std::size_t j = column(result, reference.names[i]);
    if (reference.names[i] == "t" || j == result.names.size()) {
      continue;
    }
    double scale = 1;
    for (const std::vector<double>& row : reference.rows) {
      scale = std::max(scale, std::abs(row[i]));
    }
    shared.push_back({i, j, scale});
  }
  if (shared.empty()) {
    throw std::runtime_error("the tables have no column in common but `t`");
  }
  return shared;
}

/// Rows are in order of time.
const std::vector<double>* row_at(const Table& table, std::size_t time, double t) {
  const double slack = time_tolerance * std::max(1.0, std::abs(t));
  const auto found = std::lower_bound(table.rows.begin(), table.rows.end(), t - slack,
                                      [&](const std::vector<double>& row, double at) { return row[time] < at; });
  return found == table.rows.end() || !((*found)[time] <= t + slack) ? nullptr : &*found;
}

int compare(const std::string& reference_path, const std::string& result_path, double tolerance) {
  const Table reference = read_table(reference_path);
  const Table result = read_table(result_path);
  const std::size_t reference_time = time_column(reference, reference_path);
  const std::size_t result_time = time_column(result, result_path);
  const std::vector<SharedColumn> shared = shared_columns(reference, result);

  double worst = 0;
  std::string where;
  for (const std::vector<double>& expected : reference.rows) {
    const double t = expected[reference_time];
    const std::vector<double>* const actual = row_at(result, result_time, t);
    if (actual == nullptr) {
      std::printf("differs: the result has no row at t = %.17g\n", t);
      return 1;
    }
    for (const SharedColumn& pair : shared) {
      const double d = std::abs(expected[pair.in_reference] - (*actual)[pair.in_result]) / pair.scale;
      if (!(d <= worst)) {
        worst = std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
        where = " in " + reference.names[pair.in_reference] + " at t = " + std::to_string(t);
      }
    }
  }
  const bool agrees = worst <= tolerance;
  std::printf("%s: %zu rows, %zu columns, largest difference %.3g%s, tolerance %.3g\n", agrees ? "agrees" : "differs",
              reference.rows.size(), shared.size(), worst, where.c_str(), tolerance);
  return agrees ? 0 : 1;
}

}  // namespace
}  // namespace mbcc::compare

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: mbcc-compare REFERENCE.csv RESULT.csv TOLERANCE\n", stderr);
    return 2;
  }
  try {
    return mbcc::compare::compare(argv[1], argv[2], std::stod(argv[3]));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "mbcc-compare: %s\n", error.what());
    return 2;
  }
}
