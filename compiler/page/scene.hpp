#pragma once
// The moving scene of a page: what is drawn, and from which columns.

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "figure/panels.hpp"
#include "figure/table.hpp"
#include "mechanics/derivatives.hpp"
#include "mechanics/rods.hpp"

namespace mbcc::page {

using Vector = std::array<double, 3>;  ///< x, y, z in fixed axes; zero along axes that the model lacks

struct Point {
  std::string name;                   ///< the title of its figure
  std::vector<std::string> position;  ///< columns, one for each axis of the model
  std::vector<std::string> velocity;  ///< as many, or none
};

/// A bar between two points, or from a point to a place that rests.
struct Rod {
  std::size_t point;
  std::optional<std::size_t> other;  ///< also an index into Scene::points
  Vector anchor{};                   ///< without `other`
  double length = 0;                 ///< in the first row
};

/// What points are kept on where so many hang from one place that rods would hide them.
struct Sphere {
  Vector centre{};
  double radius = 0;
};

struct Scene {
  std::size_t dimension = 3;
  Vector up{0, 0, 1};
  std::vector<Point> points;
  std::vector<Rod> rods;
  std::vector<Sphere> spheres;
};

/// What the compiler knows of a scene beyond the columns of its result.
struct Skeleton {
  struct Bar {
    std::string point;                 ///< the first column of its position
    std::optional<std::string> other;  ///< also
    Vector anchor{};                   ///< without `other`
  };
  std::vector<Bar> bars;
  Vector up{0, 0, 1};
};

/// Up is against the sum of the constant forces where that is along an axis, else z. Parameters are those of `point`.
Skeleton skeleton_of(const model::System& system, const mechanics::Equations& equations,
                     const mechanics::Derivatives& derivatives, const mechanics::Point& point);

/// The points are the particles among `figures`; bars of points that the table lacks are left out.
Scene scene_of(const figure::Table& table, std::span<const figure::Figure> figures, const Skeleton& skeleton);

}  // namespace mbcc::page
