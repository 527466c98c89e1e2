#include "page/scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace mbcc::page {

namespace {

/// From so many points on, what they share is drawn as a sphere.
constexpr std::size_t crowd = 4;

/// The sum of the constant forces on all places.
Vector pull_on(const model::System& system, const mechanics::Equations& equations, const mechanics::Point& point) {
  std::map<graph::NodeId, std::size_t> axes;  // by velocity
  for (const model::Place& place : system.places) {
    for (std::size_t axis = 0; axis < place.position.size(); ++axis) {
      axes.emplace(equations.kinematics[index(place.position[axis])].id(), axis);
    }
  }
  Vector pull{};
  for (std::size_t i = 0; i < system.forces.size(); ++i) {
    const auto axis = axes.find(equations.force_velocities[i].id());
    if (axis != axes.end() && equations.forces[i].level() <= graph::Level::Parameter) {
      pull[axis->second] += mechanics::value_at(point, equations.forces[i]);
    }
  }
  return pull;
}

/// Against `pull`, if it is along one axis.
Vector up_against(const Vector& pull) {
  if (std::count(pull.begin(), pull.end(), 0.0) != 2) {
    return {0, 0, 1};
  }
  Vector up{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    up[axis] = pull[axis] < 0 ? 1 : pull[axis] > 0 ? -1 : 0;
  }
  return up;
}

std::vector<Point> points_of(std::span<const figure::Figure> figures) {
  std::vector<Point> points;
  for (const figure::Figure& figure : figures) {
    if (!figure.position.empty()) {
      const bool moves = figure.velocity.size() == figure.position.size();
      points.push_back({figure.title, figure.position, moves ? figure.velocity : std::vector<std::string>()});
    }
  }
  return points;
}

double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Vector first_position(const figure::Table& table, const Point& point) {
  Vector position{};
  for (std::size_t axis = 0; axis < point.position.size(); ++axis) {
    position[axis] = table[point.position[axis]].front();
  }
  return position;
}

std::vector<Rod> rods_of(const figure::Table& table, const std::vector<Point>& points, const Skeleton& skeleton) {
  std::map<std::string_view, std::size_t> by_column;
  for (std::size_t i = 0; i < points.size(); ++i) {
    by_column.emplace(points[i].position.front(), i);
  }
  std::vector<Rod> rods;
  for (const Skeleton::Bar& bar : skeleton.bars) {
    const auto point = by_column.find(bar.point);
    const auto other = by_column.find(bar.other.value_or(bar.point));
    if (point == by_column.end() || other == by_column.end()) {
      continue;
    }
    Rod rod{point->second, std::nullopt, bar.anchor, 0};
    if (bar.other) {
      rod.other = other->second;
    }
    const Vector end = rod.other ? first_position(table, points[*rod.other]) : bar.anchor;
    rod.length = distance(first_position(table, points[rod.point]), end);
    rods.push_back(rod);
  }
  return rods;
}

/// Whether two rods hang from one place and are of one length, to what can be seen.
bool share_sphere(const Rod& a, const Rod& b) {
  const double same = 1e-6 * a.length;
  return !a.other && !b.other && std::abs(a.length - b.length) <= same && distance(a.anchor, b.anchor) <= same;
}

/// Moves the rods of crowds to spheres.
void replace_crowds(Scene& scene) {
  std::vector<Rod> rods;
  for (const Rod& rod : scene.rods) {
    const auto same =
        std::count_if(scene.rods.begin(), scene.rods.end(), [&](const Rod& other) { return share_sphere(rod, other); });
    if (static_cast<std::size_t>(same) < crowd) {
      rods.push_back(rod);
    } else if (std::none_of(scene.spheres.begin(), scene.spheres.end(), [&](const Sphere& sphere) {
                 return share_sphere(rod, {0, std::nullopt, sphere.centre, sphere.radius});
               })) {
      scene.spheres.push_back({rod.anchor, rod.length});
    }
  }
  scene.rods = std::move(rods);
}

}  // namespace

Skeleton skeleton_of(const model::System& system, const mechanics::Equations& equations,
                     const mechanics::Derivatives& derivatives, const mechanics::Point& point) {
  const auto column = [&](std::size_t place) { return system[system.places[place].position.front()].name; };
  Skeleton skeleton{{}, up_against(pull_on(system, equations, point))};
  for (const mechanics::Rod& rod : mechanics::find_rods(system, derivatives, point)) {
    const auto other = rod.other ? std::optional(column(*rod.other)) : std::nullopt;
    skeleton.bars.push_back({column(rod.place), other, rod.anchor});
  }
  return skeleton;
}

Scene scene_of(const figure::Table& table, std::span<const figure::Figure> figures, const Skeleton& skeleton) {
  Scene scene{3, skeleton.up, points_of(figures), {}, {}};
  scene.dimension = scene.points.empty() ? 3 : scene.points.front().position.size();
  scene.rods = rods_of(table, scene.points, skeleton);
  replace_crowds(scene);
  return scene;
}

}  // namespace mbcc::page
