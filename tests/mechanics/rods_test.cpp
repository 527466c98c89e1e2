// Which constraints are found to be rods.

#include "mechanics/rods.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/compiled.hpp"

namespace mbcc::mechanics {
namespace {

/// A line for each rod: its constraint, and the first coordinate of each place, or the anchor to six digits.
std::string rods_of(const std::string& model) {
  const Compilation c = test::compiled(model, Stage::Derivatives);
  const auto name = [&](std::size_t place) { return (*c.system)[c.system->places[place].position.front()].name; };
  std::string text;
  for (const Rod& rod : find_rods(*c.system, c.derivatives, initial_point(*c.system, c.equations))) {
    const auto [x, y, z] = rod.anchor;
    const std::string end = rod.other ? name(*rod.other) : fmt::format("({:.6g}, {:.6g}, {:.6g})", x, y, z);
    text += fmt::format("{}: {} to {}\n", c.system->constraints[rod.constraint].name, name(rod.place), end);
  }
  return text;
}

const std::string two_in_space = R"(dimension 3
particle a { mass = 1; position = (0.6, 0, -0.8) }
particle b { mass = 1; position = (0.6, 2, -0.8) }
)";

}  // namespace

TEST_CASE("a pendulum hangs on a rod however its constraint is written") {
  const auto [equation, anchor] = GENERATE(
      table<std::string, std::string>({{"norm(a.position) = 1", "(0, 0, 0)"},
                                       {"1e-6*(a.x^2 + a.y^2 + a.z^2) = 1e-6", "(0, 0, 0)"},
                                       {"sqrt(1 - exp(-dot(a.position, a.position))) = sqrt(1 - exp(-1))", "(0, 0, 0)"},
                                       {"norm(a.position - (0.6, h, 1.2)) = 2", "(0.6, 0, 1.2)"},
                                       {"(a.x - 3)^2 + a.y*(a.y - 2*h) + (a.z + 4)^2 = 2.4^2 + 3.2^2", "(3, 0, -4)"}}));
  CHECK(rods_of(two_in_space + "parameter h = 0\nconstraint c : " + equation) == "c: a.x to " + anchor + "\n");
}

TEST_CASE("an anchor stands where the parameters put it") {
  const Compilation c = test::compiled(
      two_in_space + "parameter h = 0\nconstraint c : norm(a.position - (0, h, 0)) = 1", Stage::Derivatives);
  Point point = initial_point(*c.system, c.equations);
  point.parameters = {7.25};
  const std::vector<Rod> rods = find_rods(*c.system, c.derivatives, point);
  REQUIRE(rods.size() == 1);
  CHECK(rods.front().anchor[1] == Approx(7.25).epsilon(1e-8));  // Rod promises nine digits
}

TEST_CASE("a rod between two places is one however it is written") {
  const std::string equation = GENERATE("norm(a.position - b.position) = 2", "norm(b.position - a.position)^3 = 8",
                                        "dot(a.position, a.position) + dot(b.position, b.position)"
                                        " = 4 + 2*dot(a.position, b.position)");
  CHECK(rods_of(two_in_space + "constraint c : " + equation) == "c: a.x to b.x\n");
}

TEST_CASE("what looks like a rod and is none") {
  const std::string equation =
      GENERATE("a.z = -0.8",                                                      // a plane
               "a.x^2 + a.y^2 = 0.36",                                            // a cylinder
               "a.x^2 + a.y^2 + 2*a.z^2 = 1.64",                                  // an ellipsoid
               "norm(a.position) = 1 + 0*t + sin(t)^2",                           // a length that changes
               "norm(a.position + b.position) = norm((1.2, 2, -1.6))",            // twice the middle on a sphere
               "norm(a.position - 2*b.position) = norm((-0.6, -4, 0.8))",         // opposite ends pull unequally
               "(a.x - b.x)^2 + 2*(a.y - b.y)^2 + (a.z - b.z)^2 = 8",             // a distance in stretched space
               "a.y - b.y = -2",                                                  // side by side
               "norm(a.position) + norm(b.position) = 1 + norm((0.6, 2, -0.8))",  // a string over two pulleys
               "dot(a.position, a.velocity)",                                     // a rod, but of velocities
               "a.x*a.vy = a.y*a.vx");                                            // a skate's kind
  CHECK(rods_of(two_in_space + "constraint c : " + equation) == "");
}

TEST_CASE("the rods of a chain, a four-bar linkage and points on a sphere") {
  CHECK(rods_of(R"(dimension 2
for i in 1..3 { particle p[i] { mass = 1; position = (0, -i) } }
constraint hook : norm(p[1].position)^2 = 1
for i in 2..3 { constraint link[i] : norm(p[i].position - p[i-1].position)^2 = 1 }
)") == "hook: p[1].x to (0, 0, 0)\n"
       "link[2]: p[1].x to p[2].x\n"
       "link[3]: p[2].x to p[3].x\n");
  CHECK(rods_of(R"(dimension 2
particle crank  { mass = 1; position = (0, 1); velocity = (1, 0) }
particle rocker { mass = 1; position = (2, 2.5); velocity = (1, 0) }
constraint crank_rod  : norm(crank.position)^2 = 1
constraint coupler    : norm(rocker.position - crank.position)^2 = 2.5^2
constraint rocker_rod : norm(rocker.position - (2, 0))^2 = 2.5^2
)") == "crank_rod: crank.x to (0, 0, 0)\n"
       "coupler: crank.x to rocker.x\n"
       "rocker_rod: rocker.x to (2, 0, 0)\n");
  CHECK(rods_of(R"(dimension 3
particle 1 { mass = 1; position = (1, 0, 0) }
particle 2 { mass = 1; position = (0, 1, 0) }
constraint one   : x1^2 + y1^2 + z1^2 = 1
constraint other : x2^2 + y2^2 + z2^2 = 1
)") == "one: x1 to (0, 0, 0)\n"
       "other: x2 to (0, 0, 0)\n");
}

TEST_CASE("on a line two places keep their distance, one has none to keep") {
  const std::string line =
      "dimension 1\nparticle a { mass = 1; position = 1 }\nparticle b { mass = 1; position = 3 }\n";
  CHECK(rods_of(line + "constraint c : b.x - a.x = 2") == "c: a.x to b.x\n");
  CHECK(rods_of(line + "constraint c : a.x^2 = 1") == "");
}

}  // namespace mbcc::mechanics
