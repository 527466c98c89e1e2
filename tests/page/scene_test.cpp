// What is drawn of a model and its result.

#include "page/scene.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/compiled.hpp"

namespace mbcc::page {
namespace {

Skeleton skeleton_of(const std::string& model) {
  const Compilation c = test::compiled(model, Stage::Derivatives);
  return page::skeleton_of(*c.system, c.equations, c.derivatives, mechanics::initial_point(*c.system, c.equations));
}

/// A result of one row.
figure::Table row(std::vector<std::string> names, const std::vector<double>& values) {
  figure::Table table{"result.csv", std::move(names), {}};
  for (const double value : values) {
    table.columns.push_back({value});
  }
  return table;
}

Scene scene(const figure::Table& table, const Skeleton& skeleton) {
  return scene_of(table, figure::figures_of(table.names), skeleton);
}

/// Four particles at the given distances from the origin, each on a rod from there.
Scene four_at(const std::array<double, 4>& distances) {
  Skeleton skeleton;
  std::vector<std::string> names{"t"};
  std::vector<double> values{0};
  for (std::size_t i = 0; i < distances.size(); ++i) {
    names.insert(names.end(), {fmt::format("x{}", i + 1), fmt::format("y{}", i + 1)});
    values.insert(values.end(), {0, -distances[i]});
    skeleton.bars.push_back({fmt::format("x{}", i + 1), std::nullopt, {}});
  }
  return scene(row(names, values), skeleton);
}

}  // namespace

TEST_CASE("the points are the particles of the result") {
  const Scene found = scene(
      row({"t", "x1", "y1", "bob.x", "bob.y", "vx1", "vy1", "ax1", "ay1", "spin"}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}), {});
  CHECK(found.dimension == 2);
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].name == "particle 1");
  CHECK(found.points[0].position == std::vector<std::string>{"x1", "y1"});
  CHECK(found.points[0].velocity == std::vector<std::string>{"vx1", "vy1"});
  CHECK(found.points[1].position == std::vector<std::string>{"bob.x", "bob.y"});
  CHECK(found.points[1].velocity.empty());
  CHECK(found.rods.empty());
}

TEST_CASE("rods join the points of the result and are as long as there") {
  const Skeleton skeleton = skeleton_of(R"(dimension 2
parameter L = 1
particle upper { mass = 1; position = (0, -L) }
particle lower { mass = 1; position = (0, -2*L) }
constraint hook : norm(upper.position) = L
constraint link : norm(lower.position - upper.position) = L
)");
  const Scene found = scene(row({"t", "upper.x", "upper.y", "lower.x", "lower.y"}, {0, 0, -3, 4, -3}), skeleton);
  REQUIRE(found.rods.size() == 2);
  CHECK(found.rods[0].point == 0);
  CHECK_FALSE(found.rods[0].other.has_value());
  CHECK(found.rods[0].length == 3);
  CHECK(found.rods[1].point == 0);
  CHECK(found.rods[1].other == 1U);
  CHECK(found.rods[1].length == 4);
  CHECK(scene(row({"t", "upper.x", "upper.y"}, {0, 0, -1}), skeleton).rods.size() == 1);
}

TEST_CASE("where many hang from one place at one length, that is a sphere") {
  const Scene crowd = four_at({2, 2, 2, 2});
  CHECK(crowd.rods.empty());
  REQUIRE(crowd.spheres.size() == 1);
  CHECK(crowd.spheres[0].radius == 2);
  CHECK(four_at({2, 2, 2, 3}).rods.size() == 4);
  CHECK(four_at({2, 2, 2, 3}).spheres.empty());
}

TEST_CASE("up is against the weight") {
  const std::string one = "dimension 3\nparticle 1 { mass = 2; position = (1, 0, 0); ";
  CHECK(skeleton_of(one + "}\ngravity (0, -9.81, 0)").up == Vector{0, 1, 0});
  CHECK(skeleton_of(one + "}\ngravity (0, 0, 9.81)").up == Vector{0, 0, -1});
  CHECK(skeleton_of(one + "}\ngravity (0, -9.81, 1)").up == Vector{0, 0, 1});
  CHECK(skeleton_of(one + "force = (-x1, 0, 0) }").up == Vector{0, 0, 1});
  CHECK(skeleton_of(one + "}").up == Vector{0, 0, 1});
}

}  // namespace mbcc::page
