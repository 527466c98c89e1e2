#include "exact.hpp"

#include <algorithm>
#include <cmath>
#include <mbrt/island.hpp>

#include "support/compiled.hpp"
#include "support/tracked.hpp"

namespace mbcc::test {

using graph::Expr;
using graph::Kind;
using graph::Node;
using mbrt::test::QuadMatrix;

namespace {

template <class T>
std::vector<T> values(const Compilation& c, const std::vector<Expr>& expressions, double time,
                      const std::vector<double>& state) {
  const auto leaf = [&](const Node& node) {
    switch (node.kind) {
      case Kind::Constant:
        return T(node.value);
      case Kind::Time:
        return T(time);
      case Kind::Parameter:
        return T(c.system->parameters[node.index].value);
      case Kind::Coordinate:
        return T(state[node.index]);
      default:
        return T(state[c.system->coordinates.size() + node.index]);
    }
  };
  return graph::evaluate<T>(*c.graph, expressions, leaf);
}

double norm(const std::vector<Quad>& x) { return static_cast<double>(sqrt(mbrt::test::dot(x, x))); }

/// |r - B w|: by how much the constraints ask for accelerations that no motion has.
double contradiction(const QuadMatrix& b, std::vector<Quad> r, const std::vector<Quad>& w) {
  for (std::size_t k = 0; k < r.size(); ++k) {
    r[k] -= mbrt::test::dot(b[k], w);
  }
  return norm(r);
}

}  // namespace

/// B = A M^-1/2 and r = b - A a, not scaled, and a, with bounds of the rounding errors that they have in double
/// precision: every term counts, also those which cancel.
struct ExactModel::Rows {
  QuadMatrix b;
  std::vector<Quad> r;
  std::vector<double> b_error, r_error;  ///< per row
  std::vector<Quad> free, mobility;
  double free_error = 0;  ///< of |M^1/2 a|
};

ExactModel::ExactModel(const Compilation& compilation) : compilation_(compilation) {
  const std::vector<double> start = start_state(compilation);
  for (const mechanics::Island& island : compilation.derivatives.islands) {
    const Rows rows = rows_at(island, all_rows(island), 0, start);
    std::vector<Quad>& scales = scales_.emplace_back();
    for (const std::vector<Quad>& row : rows.b) {
      scales.push_back(1 / sqrt(mbrt::test::dot(row, row)));
    }
  }
}

/// In the order of the model, those that the compiler holds to be implied by others among them.
std::vector<std::size_t> ExactModel::all_rows(const mechanics::Island& island) const {
  std::vector<std::size_t> rows = island.rows;
  rows.insert(rows.end(), island.held.begin(), island.held.end());
  std::sort(rows.begin(), rows.end());
  return rows;
}

ExactModel::Rows ExactModel::rows_at(const mechanics::Island& island, const std::vector<std::size_t>& indices,
                                     double time, const std::vector<double>& state) const {
  const mechanics::Derivatives& derivatives = compilation_.derivatives;
  Rows rows;
  std::vector<Expr> speeds;
  for (const std::size_t speed : island.speeds) {
    speeds.push_back(derivatives.free[speed]);
    speeds.push_back(derivatives.mobility[speed]);
  }
  const std::vector<Quad> of_speeds = values<Quad>(compilation_, speeds, time, state);
  const std::vector<Tracked> rounded = values<Tracked>(compilation_, speeds, time, state);
  for (std::size_t j = 0; j < island.speeds.size(); ++j) {
    rows.free.push_back(of_speeds[2 * j]);
    rows.mobility.push_back(of_speeds[2 * j + 1]);
    rows.free_error = std::hypot(rows.free_error, rounded[2 * j].error / std::sqrt(rounded[2 * j + 1].value));
  }
  for (const std::size_t index : indices) {
    const mechanics::Row& row = derivatives.rows[index];
    std::vector<Expr> expressions{row.b, row.residual};
    for (const mechanics::Entry& entry : row.entries) {
      expressions.push_back(entry.value);
    }
    const std::vector<Quad> exact = values<Quad>(compilation_, expressions, time, state);
    const std::vector<Tracked> tracked = values<Tracked>(compilation_, expressions, time, state);
    std::vector<Quad> b(island.speeds.size(), Quad(0));
    Quad r = exact[0], error = 0;
    for (std::size_t e = 0; e < row.entries.size(); ++e) {
      const auto j = static_cast<std::size_t>(
          std::lower_bound(island.speeds.begin(), island.speeds.end(), row.entries[e].speed) - island.speeds.begin());
      b[j] = exact[2 + e] * sqrt(rows.mobility[j]);
      r -= exact[2 + e] * rows.free[j];
      error += Quad(tracked[2 + e].error) * tracked[2 + e].error * rows.mobility[j];
    }
    rows.b.push_back(b);
    rows.r.push_back(r);
    rows.b_error.push_back(static_cast<double>(sqrt(error)));
    rows.r_error.push_back(tracked[1].error);
  }
  return rows;
}

ExactIsland ExactModel::solve(std::size_t index, double time, const std::vector<double>& state) const {
  const mechanics::Island& island = compilation_.derivatives.islands[index];
  Rows rows = rows_at(island, all_rows(island), time, state);
  double b_error = 0, r_error = 0;
  for (std::size_t k = 0; k < rows.b.size(); ++k) {
    const Quad scale = scales_[index][k];
    rows.r[k] *= scale;
    for (Quad& entry : rows.b[k]) {
      entry *= scale;
    }
    b_error = std::hypot(b_error, static_cast<double>(scale) * rows.b_error[k]);
    r_error = std::hypot(r_error, static_cast<double>(scale) * rows.r_error[k]);
  }
  const mbrt::test::Truncated pinv = mbrt::test::truncated_pinv(rows.b, rows.r, mbrt::default_cutoff);
  const double added = norm(pinv.solution);
  const double kept = static_cast<double>(pinv.smallest_kept);
  ExactIsland exact;
  exact.is_deficient = pinv.rank < rows.b.size();
  std::vector<Quad> weighted, weighted_free;
  for (std::size_t j = 0; j < island.speeds.size(); ++j) {
    const Quad root = sqrt(rows.mobility[j]);
    exact.components.push_back(compilation_.system->coordinates.size() + island.speeds[j]);
    exact.acceleration.push_back(rows.free[j] + root * pinv.solution[j]);
    exact.inertia.push_back(1 / rows.mobility[j]);
    weighted.push_back(exact.acceleration[j] / root);
    weighted_free.push_back(rows.free[j] / root);
  }
  exact.size = norm(weighted);
  exact.parts = norm(weighted_free) + added;
  exact.condition = static_cast<double>(pinv.largest / pinv.smallest_kept);
  // The subspaces that are kept differ by an angle of dropped/kept, and r weighs in with up to the condition.
  exact.truncation = 10 * static_cast<double>(pinv.largest_dropped) / kept * exact.condition * added;
  exact.contradiction = contradiction(rows.b, rows.r, pinv.solution) / kept;
  // Note [rounded rows] in exact.hpp
  exact.rounding = rows.free_error + (r_error + b_error * (2 * added + exact.contradiction)) / kept;
  const Quad cut = mbrt::default_cutoff * std::max(pinv.largest, Quad(1));
  exact.is_ambiguous = pinv.largest_dropped > cut / 10 || pinv.smallest_kept < cut * 10;
  return exact;
}

std::vector<ExactIsland> ExactModel::at(double time, const std::vector<double>& state) const {
  std::vector<ExactIsland> islands;
  for (std::size_t i = 0; i < compilation_.derivatives.islands.size(); ++i) {
    islands.push_back(solve(i, time, state));
  }
  return islands;
}

double distance(const ExactIsland& island, const std::vector<double>& rate) {
  Quad sum = 0;
  for (std::size_t j = 0; j < island.components.size(); ++j) {
    const Quad difference = rate[island.components[j]] - island.acceleration[j];
    sum += island.inertia[j] * difference * difference;
  }
  return static_cast<double>(sqrt(sum));
}

}  // namespace mbcc::test
