#include "mechanics/examine.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "mechanics/dependence.hpp"
#include "mechanics/directions.hpp"
#include "mechanics/point.hpp"

namespace mbcc {

namespace mechanics {

namespace {

/// One constraint in numbers at the start.
struct RowValues {
  double value;         ///< h or g
  double rate;          ///< h' or g
  double residual;      ///< b - A a
  double size;          ///< |A_k|
  double acceleration;  ///< |b| + sum |A_kj a_j|: what a residual has to be compared with
  bool finite;
};

class Examiner {
 public:
  Examiner(const model::System& system, const Equations& equations, const Derivatives& derivatives,
           Diagnostics& diagnostics)
      : system_(system),
        equations_(equations),
        derivatives_(derivatives),
        diagnostics_(diagnostics),
        start_(initial_point(system, equations)) {}

  Examination examine(Start start) {
    Examination found;
    if (!check_start_is_finite() || !check_inertia()) {
      return found;
    }
    for (const Row& row : derivatives_.rows) {
      rows_.push_back(evaluate(row));
      check_row(row, rows_.back());
    }
    if (diagnostics_.has_errors()) {
      return found;
    }
    std::vector<bool> contradicting(rows_.size());
    for (const Island& island : derivatives_.islands) {
      const std::vector<Dependence> dependences = find_dependences(island, derivatives_, start_);
      const std::size_t rows = island.rows.size() + island.held.size();
      found.ranks.push_back(rows - dependences.size());
      for (const Dependence& dependence : dependences) {
        found.redundant.push_back(dependence.row);
        // Off the constraints, rows that agree on them need not agree: the run will tell, where it starts.
        contradicting[dependence.row] = start == Start::Consistent && check_contradiction(dependence);
        if (!contradicting[dependence.row]) {
          const model::Constraint& constraint = system_.constraints[dependence.row];
          diagnostics_.report(Finding::RedundantConstraint, constraint.span, constraint.name, found.ranks.back(), rows);
        }
      }
    }
    for (const Row& row : derivatives_.rows) {
      if (start == Start::Consistent && !contradicting[row.constraint]) {
        check_start_holds(row);
      }
    }
    return found;
  }

 private:
  bool check_start_is_finite() {
    bool finite = true;
    const auto check = [&](double value, const std::string& what, Span span) {
      if (!std::isfinite(value)) {
        diagnostics_.report(Finding::NotFiniteAtStart, span, what);
        finite = false;
      }
    };
    for (std::size_t i = 0; i < system_.coordinates.size(); ++i) {
      check(start_.coordinates[i], "`" + system_.coordinates[i].name + "`", system_.coordinates[i].span);
    }
    for (std::size_t j = 0; j < system_.speeds.size(); ++j) {
      check(start_.speeds[j], "`" + system_.speeds[j].name + "`", system_.speeds[j].span);
    }
    const std::vector<double> masses = values_at(start_, equations_.inertia);
    for (std::size_t j = 0; j < masses.size(); ++j) {
      check(masses[j], "the mass behind `" + system_.speeds[j].name + "`", system_.speeds[j].span);
    }
    const std::vector<double> forces = values_at(start_, equations_.forces);
    for (std::size_t i = 0; i < forces.size() && finite; ++i) {
      check(forces[i], system_.forces[i].name, system_.forces[i].span);
    }
    return finite;
  }

  bool check_inertia() {
    for (const std::size_t speed : derivatives_.undetermined) {
      diagnostics_.report(Finding::NoInertia, system_.speeds[speed].span, system_.speeds[speed].name);
    }
    constexpr double rounding = 1e-12;  // what remains of an inertia that is no more than a combination of others
    const std::vector<double> whole = values_at(start_, derivatives_.inertia);
    const std::vector<double> mobility = values_at(start_, derivatives_.mobility);
    for (std::size_t j = 0; j < whole.size(); ++j) {
      if (!(1 / mobility[j] > rounding * std::abs(whole[j]))) {
        diagnostics_.report(Finding::InertiaNotPositive, system_.speeds[j].span, system_.speeds[j].name,
                            1 / mobility[j]);
      }
    }
    check_kinetic_energies();
    const std::optional<std::size_t> changing = find_changing_inertia(derivatives_);
    if (system_.integration.method == "taylor" && changing) {
      diagnostics_.report(Finding::NoSeries, system_.speeds[*changing].span, system_.speeds[*changing].name);
    }
    return !diagnostics_.has_errors();
  }

  /// Note [energies] in energies.hpp: speeds that are no rates may occur where kinematics are constant.
  void check_kinetic_energies() {
    std::set<std::size_t> turning;  // speeds that move coordinates in ways that change
    for (const Expr rate : equations_.kinematics) {
      for (const auto& [speed, direction] : partials_along_speeds(rate)) {
        if (direction.level() > graph::Level::Parameter) {
          turning.insert(speed);
        }
      }
    }
    for (const model::Coordinate& coordinate : system_.coordinates) {
      if (const std::optional<model::SpeedId> speed = system_.speed_of(coordinate)) {
        turning.erase(model::index(*speed));
      }
    }
    for (std::size_t k = 0; k < equations_.kinetic.size(); ++k) {
      for (const std::uint32_t speed : occurring(equations_.kinetic[k], Kind::Speed)) {
        if (turning.contains(speed)) {
          diagnostics_.report(Finding::KineticOfSpeed, system_.kinetic[k].span, system_.speeds[speed].name);
        }
      }
    }
  }

  RowValues evaluate(const Row& row) const {
    std::vector<Expr> expressions{row.value, row.rate, row.residual, row.b};
    for (const Entry& entry : row.solved) {
      expressions.push_back(entry.value);
      expressions.push_back(derivatives_.free[entry.speed]);
    }
    const std::vector<double> values = values_at(start_, expressions);
    RowValues result{values[0], values[1], values[2], 0, std::abs(values[3]), true};
    for (std::size_t i = 4; i < values.size(); i += 2) {
      result.size = std::hypot(result.size, values[i]);
      result.acceleration += std::abs(values[i] * values[i + 1]);
    }
    result.finite = std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
    return result;
  }

  void check_row(const Row& row, const RowValues& values) {
    const model::Constraint& constraint = system_.constraints[row.constraint];
    if (!values.finite) {
      diagnostics_.report(Finding::NotFiniteAtStart, constraint.span, "constraint `" + constraint.name + "`");
    } else if (row.entries.empty() && is_zero(row.value)) {
      diagnostics_.report(Finding::IdenticallyTrue, constraint.span, constraint.name);
    } else if (row.entries.empty()) {
      diagnostics_.report(Finding::ConstrainsNothing, constraint.span, constraint.name);
    }
  }

  /// A row that depends on others must ask for what they ask for, at every level.
  bool check_contradiction(const Dependence& dependence) {
    const bool holonomic = system_.constraints[dependence.row].holonomic &&
                           std::all_of(dependence.on.begin(), dependence.on.end(),
                                       [&](const auto& on) { return system_.constraints[on.first].holonomic; });
    const double size = std::max(rows_[dependence.row].size, 1e-300);
    if (holonomic && disagrees(dependence, &RowValues::value, start_tolerance * length() * size, "position")) {
      return true;
    }
    if (disagrees(dependence, &RowValues::rate, start_tolerance * speed() * size, "velocity")) {
      return true;
    }
    // A start that is off by the tolerance leaves as much in the accelerations: a hundred times that is no rounding.
    double scale = rows_[dependence.row].acceleration;
    for (const auto& [row, coefficient] : dependence.on) {
      scale += std::abs(coefficient) * rows_[row].acceleration;
    }
    return disagrees(dependence, &RowValues::residual, 100 * start_tolerance * scale, "acceleration");
  }

  bool disagrees(const Dependence& dependence, double RowValues::*level, double tolerance, const char* name) {
    double difference = rows_[dependence.row].*level;
    for (const auto& [row, coefficient] : dependence.on) {
      difference -= coefficient * (rows_[row].*level);
    }
    if (std::abs(difference) <= tolerance) {
      return false;
    }
    const model::Constraint& constraint = system_.constraints[dependence.row];
    Diagnostic& report = diagnostics_.report(Finding::ContradictoryConstraints, constraint.span, constraint.name, name,
                                             std::abs(difference));
    for (const auto& [row, coefficient] : dependence.on) {
      report.note(system_.constraints[row].span, "constraint `" + system_.constraints[row].name + "` is here");
    }
    return true;
  }

  void check_start_holds(const Row& row) {
    const model::Constraint& constraint = system_.constraints[row.constraint];
    const RowValues& values = rows_[row.constraint];
    const double size = values.size > 0 ? values.size : 1;
    const double position = std::abs(values.value) / size;
    if (constraint.holonomic && position > start_tolerance * length()) {
      diagnostics_.report(Finding::StartOffPosition, constraint.span, constraint.name, values.value, position);
      return;
    }
    const double velocity = std::abs(values.rate) / size;
    if (velocity > start_tolerance * speed()) {
      diagnostics_.report(Finding::StartOffVelocity, constraint.span, constraint.name,
                          constraint.holonomic ? "its rate" : "its value", values.rate, velocity);
    }
  }

  static double at_least_one(const std::vector<double>& values) {
    double size = 1;
    for (const double value : values) {
      size = std::max(size, std::abs(value));
    }
    return size;
  }
  double length() const { return at_least_one(start_.coordinates); }
  double speed() const { return at_least_one(start_.speeds); }

  const model::System& system_;
  const Equations& equations_;
  const Derivatives& derivatives_;
  Diagnostics& diagnostics_;
  Point start_;
  std::vector<RowValues> rows_;
};

}  // namespace

}  // namespace mechanics

mechanics::Examination examine(const model::System& system, const mechanics::Equations& equations,
                               const mechanics::Derivatives& derivatives, mechanics::Start start,
                               Diagnostics& diagnostics) {
  return mechanics::Examiner(system, equations, derivatives, diagnostics).examine(start);
}

}  // namespace mbcc
