// mbcc-compare REFERENCE.csv RESULT.csv TOLERANCE: does a trajectory agree with its reference?
//
// The measure is the largest |d| / max(1, max|column of the reference|) over the columns that both tables have. Rows
// are matched by `t`; the result may have more of them, not fewer. Exit code 0: agrees; 1: does not; 2: cannot tell.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "diagnostics/render.hpp"
#include "figure/table.hpp"

namespace mbcc::compare {
namespace {

using figure::Table;

/// Two programs may round their sampling times differently. Far below any step; and a shift by so much that it matters
/// shows in the columns themselves.
constexpr double time_tolerance = 1e-9;

/// Nothing, with a message, if there is no such table.
std::optional<Table> read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    std::fprintf(stderr, "mbcc-compare: cannot read `%s`\n", path.c_str());
    return std::nullopt;
  }
  Sources sources;
  Diagnostics diagnostics;
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  std::optional<Table> table = figure::read_table(sources, sources.add(path, text), diagnostics);
  std::fputs(render(diagnostics, sources).c_str(), stderr);
  return table;
}

/// A column of both tables, and what its differences are measured by.
struct SharedColumn {
  std::string name;
  std::span<const double> reference;
  std::span<const double> result;
  double scale;
};

std::vector<SharedColumn> shared_columns(const Table& reference, const Table& result) {
  std::vector<SharedColumn> shared;
  for (const std::string& name : reference.names) {
    if (name == "t" || result[name].empty()) {
      continue;
    }
    double scale = 1;
    for (const double value : reference[name]) {
      scale = std::max(scale, std::abs(value));
    }
    shared.push_back({name, reference[name], result[name], scale});
  }
  return shared;
}

/// The row at time `t`, or times.size(). Times are in order.
std::size_t row_at(std::span<const double> times, double t) {
  const double slack = time_tolerance * std::max(1.0, std::abs(t));
  const auto found = std::lower_bound(times.begin(), times.end(), t - slack);
  return found == times.end() || !(*found <= t + slack) ? times.size()
                                                        : static_cast<std::size_t>(found - times.begin());
}

int compare(const Table& reference, const Table& result, double tolerance) {
  const std::vector<SharedColumn> shared = shared_columns(reference, result);
  if (shared.empty()) {
    std::fputs("mbcc-compare: the tables have no column in common but `t`\n", stderr);
    return 2;
  }
  double worst = 0;
  std::string where;
  for (std::size_t row = 0; row < reference.time().size(); ++row) {
    const double t = reference.time()[row];
    const std::size_t actual = row_at(result.time(), t);
    if (actual == result.time().size()) {
      std::printf("differs: the result has no row at t = %.17g\n", t);
      return 1;
    }
    for (const SharedColumn& column : shared) {
      const double d = std::abs(column.reference[row] - column.result[actual]) / column.scale;
      if (!(d <= worst)) {
        worst = std::isnan(d) ? std::numeric_limits<double>::infinity() : d;
        where = " in " + column.name + " at t = " + std::to_string(t);
      }
    }
  }
  const bool agrees = worst <= tolerance;
  std::printf("%s: %zu rows, %zu columns, largest difference %.3g%s, tolerance %.3g\n", agrees ? "agrees" : "differs",
              reference.time().size(), shared.size(), worst, where.c_str(), tolerance);
  return agrees ? 0 : 1;
}

}  // namespace
}  // namespace mbcc::compare

int main(int argc, char** argv) {
  const std::string text = argc == 4 ? argv[3] : "";
  double tolerance = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), tolerance);
  if (error != std::errc() || end != text.data() + text.size()) {
    std::fputs("usage: mbcc-compare REFERENCE.csv RESULT.csv TOLERANCE\n", stderr);
    return 2;
  }
  const auto reference = mbcc::compare::read(argv[1]);
  const auto result = mbcc::compare::read(argv[2]);
  return reference && result ? mbcc::compare::compare(*reference, *result, tolerance) : 2;
}
