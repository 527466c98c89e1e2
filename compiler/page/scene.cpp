#include "page/scene.hpp"

#include <algorithm>
#include <cmath>

namespace mbcc::page {

namespace {

/// From so many points on, what they share is drawn as a sphere.
constexpr std::size_t crowd = 4;

/// Against the sum of the constant forces, if it is along one axis.
Vector up_of(const model::System& system, const mechanics::Equations& equations, const mechanics::Point& point) {
  Vector pull{};
  for (std::size_t i = 0; i < system.forces.size(); ++i) {
    if (equations.forces[i].level() > graph::Level::Parameter) {
      continue;
    }
    for (const model::Place& place : system.places) {
      for (std::size_t axis = 0; axis < place.position.size(); ++axis) {
        if (system[place.position[axis]].rate == system.forces[i].speed) {
          pull[axis] += mechanics::value_at(point, equations.forces[i]);
        }
      }
    }
  }
  const auto acts = [&](std::size_t axis) { return pull[axis] != 0; };
  Vector up{0, 0, 1};
  if (acts(0) + acts(1) + acts(2) == 1) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      up[axis] = acts(axis) ? -std::copysign(1.0, pull[axis]) : 0;
    }
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

std::optional<std::size_t> find_point(const std::vector<Point>& points, const std::string& column) {
  const auto found =
      std::find_if(points.begin(), points.end(), [&](const Point& point) { return point.position.front() == column; });
  return found == points.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - points.begin()));
}

std::vector<Rod> rods_of(const figure::Table& table, const std::vector<Point>& points, const Skeleton& skeleton) {
  std::vector<Rod> rods;
  for (const Skeleton::Bar& bar : skeleton.bars) {
    const auto point = find_point(points, bar.point);
    const auto other = bar.other ? find_point(points, *bar.other) : std::nullopt;
    if (!point || (bar.other && !other)) {
      continue;
    }
    const Vector end = other ? first_position(table, points[*other]) : bar.anchor;
    rods.push_back({*point, other, bar.anchor, distance(first_position(table, points[*point]), end)});
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
  Skeleton skeleton{{}, up_of(system, equations, point)};
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
