#include "mechanics/rods.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "graph/evaluate.hpp"

namespace mbcc::mechanics {

namespace {

using Vector = Eigen::Vector3d;

/// Gradients of a rod agree with its line up to rounding, about 1e-14 at these states; those of anything else miss it
/// by a part of their own size at some of them.
constexpr double tolerance = 1e-9;
/// Least eigenvalue of the mean projection across the gradients that still makes one meeting point: directions at
/// random states give about a third.
constexpr double least_spread = 1e-3;
constexpr std::size_t states = 8;

/// The states at which constraints are looked at: `point` with its coordinates moved about, the same ones every time.
std::vector<Point> states_around(const Point& point) {
  double reach = 1;
  for (const double coordinate : point.coordinates) {
    reach = std::max(reach, std::abs(coordinate));
  }
  std::mt19937 bits(1);  // raw bits are the same with every standard library, unlike its distributions
  std::vector<Point> result(states, point);
  for (Point& state : result) {
    for (double& coordinate : state.coordinates) {
      coordinate += reach * (2.0 * static_cast<double>(bits()) / static_cast<double>(std::mt19937::max()) - 1);
    }
  }
  return result;
}

/// A constraint as seen from the places that it depends on: along each, where it is and the gradient, state by state.
struct Sight {
  std::size_t place;
  std::vector<Vector> positions;
  std::vector<Vector> gradients;
};

struct Component {
  std::size_t place;
  Eigen::Index axis;
};

/// The place that each speed moves; speeds that move none are absent.
std::map<std::size_t, Component> components_by_speed(const model::System& system) {
  std::map<std::size_t, Component> result;
  for (std::size_t place = 0; place < system.places.size(); ++place) {
    for (std::size_t axis = 0; axis < system.places[place].position.size(); ++axis) {
      const model::Coordinate& coordinate = system[system.places[place].position[axis]];
      result.emplace(index(*system.speed_of(coordinate)), Component{place, static_cast<Eigen::Index>(axis)});
    }
  }
  return result;
}

bool depends_on_time(Expr value) {
  const std::vector<graph::NodeId> nodes = graph::reachable(value.graph(), std::array{value});
  return std::any_of(nodes.begin(), nodes.end(),
                     [&](graph::NodeId id) { return value.graph()[id].kind == graph::Kind::Time; });
}

class RodFinder {
 public:
  RodFinder(const model::System& system, const Point& point)
      : system_(system), components_(components_by_speed(system)), states_(states_around(point)) {}

  std::optional<Rod> find(const Row& row) const {
    if (!system_.constraints[row.constraint].holonomic || depends_on_time(row.value)) {
      return std::nullopt;
    }
    const std::vector<Sight> sights = sights_of(row);
    if (sights.size() == 2 && in_line(sights[0], sights[1])) {
      return Rod{row.constraint, sights[0].place, sights[1].place, {}};
    }
    if (sights.size() == 1 && system_.dimension > 1) {
      if (const auto anchor = meeting_point(sights[0])) {
        return Rod{row.constraint, sights[0].place, std::nullopt, *anchor};
      }
    }
    return std::nullopt;
  }

 private:
  /// None if the constraint depends on more than two places, or on something that is no place.
  std::vector<Sight> sights_of(const Row& row) const {
    std::vector<Sight> sights;
    std::vector<std::pair<std::size_t, Eigen::Index>> where;
    std::vector<Expr> slopes;
    for (const Entry& entry : row.entries) {
      const auto component = components_.find(entry.speed);
      if (component == components_.end()) {
        return {};
      }
      const auto [place, axis] = component->second;
      if (sights.empty() || sights.back().place != place) {
        sights.push_back({place, {}, std::vector<Vector>(states, Vector::Zero())});
      }
      where.emplace_back(sights.size() - 1, axis);
      slopes.push_back(entry.value);
    }
    if (sights.size() > 2) {
      return {};
    }
    for (std::size_t state = 0; state < states; ++state) {
      const std::vector<double> values = values_at(states_[state], slopes);
      for (std::size_t i = 0; i < values.size(); ++i) {
        sights[where[i].first].gradients[state](where[i].second) = values[i];
      }
      for (Sight& sight : sights) {
        sight.positions.push_back(position(sight.place, state));
      }
    }
    return sights;
  }

  Vector position(std::size_t place, std::size_t state) const {
    Vector result = Vector::Zero();
    for (std::size_t axis = 0; axis < system_.places[place].position.size(); ++axis) {
      result(static_cast<Eigen::Index>(axis)) = states_[state].coordinates[index(system_.places[place].position[axis])];
    }
    return result;
  }

  static bool in_line(const Sight& one, const Sight& other) {
    for (std::size_t state = 0; state < states; ++state) {
      const Vector line = (one.positions[state] - other.positions[state]).normalized();
      const Vector& gradient = one.gradients[state];
      const double size = gradient.norm();
      const bool opposite = (gradient + other.gradients[state]).norm() <= tolerance * size;
      const bool along = (gradient - gradient.dot(line) * line).norm() <= tolerance * size;
      if (!(size > 0 && opposite && along)) {  // a gradient that is not a number is none of this
        return false;
      }
    }
    return true;
  }

  /// Where the lines along the gradients meet: the point with the least squares of the distances, if these are zero.
  std::optional<std::array<double, 3>> meeting_point(const Sight& sight) const {
    const Eigen::Index dimension = system_.dimension;
    Eigen::MatrixXd across = Eigen::MatrixXd::Zero(dimension, dimension);
    Eigen::VectorXd offset = Eigen::VectorXd::Zero(dimension);
    std::vector<Eigen::MatrixXd> projections;
    for (std::size_t state = 0; state < states; ++state) {
      const Eigen::VectorXd line = sight.gradients[state].head(dimension).normalized();
      projections.emplace_back(Eigen::MatrixXd::Identity(dimension, dimension) - line * line.transpose());
      across += projections.back() / states;
      offset += projections.back() * sight.positions[state].head(dimension) / states;
    }
    if (!across.allFinite()) {
      return std::nullopt;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(across);
    if (eigen.eigenvalues()(0) < least_spread) {
      return std::nullopt;
    }
    const Eigen::VectorXd anchor = across.ldlt().solve(offset);
    for (std::size_t state = 0; state < states; ++state) {
      const Eigen::VectorXd arm = anchor - sight.positions[state].head(dimension);
      if (!((projections[state] * arm).norm() <= tolerance / least_spread * arm.norm())) {
        return std::nullopt;
      }
    }
    return rounded(anchor, sight.positions.front().norm());
  }

  /// Without the rounding of the solution, so that an anchor at zero is at zero: a multiple of a power of two.
  static std::array<double, 3> rounded(const Eigen::VectorXd& anchor, double size) {
    const double grain = std::exp2(std::floor(std::log2(tolerance * size)));
    std::array<double, 3> result{};
    for (Eigen::Index axis = 0; axis < anchor.size(); ++axis) {
      result[static_cast<std::size_t>(axis)] = std::round(anchor(axis) / grain) * grain + 0.0;  // no -0
    }
    return result;
  }

  const model::System& system_;
  std::map<std::size_t, Component> components_;
  std::vector<Point> states_;
};

}  // namespace

std::vector<Rod> find_rods(const model::System& system, const Derivatives& derivatives, const Point& point) {
  const RodFinder finder(system, point);
  std::vector<Rod> rods;
  for (const Row& row : derivatives.rows) {
    if (const std::optional<Rod> rod = finder.find(row)) {
      rods.push_back(*rod);
    }
  }
  return rods;
}

}  // namespace mbcc::mechanics
