#include "mechanics/redundancy.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <random>
#include <set>

#include "mechanics/dependence.hpp"
#include "mechanics/point.hpp"

namespace mbcc::mechanics {

namespace {

constexpr int points_needed = 3;
constexpr int points_tried = 12;
/// Coefficients come from a least-squares solution of rows of size 1: their error is near eps over the cut-off of
/// find_dependences.
constexpr double same_coefficient = 1e-6;
/// Between rows of size 1: without the row the condition of the rest is at most about this many times larger.
constexpr double largest_growth = 10;

/// Random states around the start, with parameters around their defaults. Deterministic: the same on every machine.
class NearbyPoints {
 public:
  NearbyPoints(const model::System& system, const Equations& equations) : start_(initial_point(system, equations)) {}

  Point next() {
    Point point = start_;
    point.time += uniform();
    for (double& parameter : point.parameters) {
      parameter += 0.1 * uniform() * (parameter == 0 ? 1 : parameter);
    }
    for (auto* values : {&point.coordinates, &point.speeds}) {
      for (double& value : *values) {
        value += uniform() * std::max(0.25, 0.25 * std::abs(value));
      }
    }
    return point;
  }

 private:
  /// In [-1, 1); the standard's distributions differ between libraries.
  double uniform() { return static_cast<double>(generator_() >> 11U) * 0x1p-52 - 1; }

  Point start_;
  std::mt19937_64 generator_{20040415};
};

/// Right-hand sides b of all rows of the island; empty if a row is not finite at `point`.
std::map<std::size_t, double> right_sides(const Island& island, const Derivatives& derivatives, const Point& point) {
  std::vector<Expr> expressions;
  for (const std::size_t row : island.rows) {
    expressions.push_back(derivatives.rows[row].b);
  }
  for (const std::size_t row : island.rows) {
    for (const Entry& entry : derivatives.rows[row].entries) {
      expressions.push_back(entry.value);
    }
  }
  const std::vector<double> values = values_at(point, expressions);
  std::map<std::size_t, double> sides;
  if (std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); })) {
    for (std::size_t k = 0; k < island.rows.size(); ++k) {
      sides.emplace(island.rows[k], values[k]);
    }
  }
  return sides;
}

/// Whether the right sides combine as the rows do.
bool agrees(const Dependence& dependence, const std::map<std::size_t, double>& sides) {
  double difference = sides.at(dependence.row);
  double size = std::abs(difference);
  for (const auto& [row, coefficient] : dependence.on) {
    difference -= coefficient * sides.at(row);
    size += std::abs(coefficient * sides.at(row));
  }
  return std::abs(difference) <= same_coefficient * size;
}

/// Whether values of the row come from pieces of functions (abs, max, if and others).
bool is_piecewise(const Row& row) {
  std::vector<Expr> rest{row.b};
  for (const Entry& entry : row.entries) {
    rest.push_back(entry.value);
  }
  std::set<Expr> seen;
  while (!rest.empty()) {
    const Expr expression = rest.back();
    rest.pop_back();
    if (!seen.insert(expression).second) {
      continue;
    }
    const graph::Node& node = expression.node();
    if (node.kind == graph::Kind::Apply && graph::row(node.op).recurrence == graph::Recurrence::Switch) {
      return true;
    }
    for (const graph::NodeId operand : node.used_operands()) {
      rest.push_back(expression.graph().at(operand));
    }
  }
  return false;
}

bool is_piecewise(const Dependence& dependence, const Derivatives& derivatives) {
  return is_piecewise(derivatives.rows[dependence.row]) ||
         std::any_of(dependence.on.begin(), dependence.on.end(),
                     [&](const auto& on) { return is_piecewise(derivatives.rows[on.first]); });
}

bool same(const Dependence& a, const Dependence& b) {
  return a.row == b.row && a.on.size() == b.on.size() &&
         std::equal(a.on.begin(), a.on.end(), b.on.begin(), [](const auto& on_a, const auto& on_b) {
           return on_a.first == on_b.first &&
                  std::abs(on_a.second - on_b.second) <= same_coefficient * std::abs(on_a.second);
         });
}

}  // namespace

std::vector<std::size_t> find_implied_rows(const Island& island, const model::System& system,
                                           const Equations& equations, const Derivatives& derivatives) {
  if (island.rows.size() < 2) {
    return {};  // nothing that could imply a row
  }
  NearbyPoints points(system, equations);
  std::optional<std::vector<Dependence>> implied;  // at every point so far
  int found = 0;
  for (int tried = 0; tried < points_tried && found < points_needed; ++tried) {
    const Point point = points.next();
    const std::map<std::size_t, double> sides = right_sides(island, derivatives, point);
    if (sides.empty()) {
      continue;
    }
    ++found;
    std::vector<Dependence> here = find_dependences(island, derivatives, point);
    std::erase_if(here, [&](const Dependence& dependence) {
      return dependence.on.empty() || dependence.growth > largest_growth || !agrees(dependence, sides) ||
             (implied && std::none_of(implied->begin(), implied->end(),
                                      [&](const Dependence& earlier) { return same(earlier, dependence); }));
    });
    implied = std::move(here);
    if (implied->empty()) {
      return {};
    }
  }
  std::vector<std::size_t> rows;
  if (found == points_needed) {
    for (const Dependence& dependence : *implied) {
      if (!is_piecewise(dependence, derivatives)) {
        rows.push_back(dependence.row);
      }
    }
  }
  return rows;
}

}  // namespace mbcc::mechanics
