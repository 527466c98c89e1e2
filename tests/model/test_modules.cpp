// Parts, points and modules that run alone. Messages about them are in the transcript.

#include <catch2/catch.hpp>

#include "resolved.hpp"

namespace mbcc {
namespace {

using test::printed;
using test::resolve_files;
using test::system_of;

TEST_CASE("what a part declares has the part's name before its own") {
  CHECK(printed("dimension 2\n"
                "module Spring(k, rest = 1) {\n"
                "  port here; point there = (0, 0)\n"
                "  parameter damping = 2*k\n"
                "  let along = there - here\n"
                "  force on here = (k*(norm(along) - rest) - damping)*along\n"
                "  output length = norm(along)\n"
                "}\n"
                "module Bob(m) { particle bob { mass = m; position = 0 }\nconstraint : bob.x = 0; constraint pin : "
                "bob.y = 0 }\n"
                "for i in 1..2 { part weight[i] = Bob(m = 3*i) }\n"
                "part spring = Spring(k = 5) { here = weight[2].bob.position }\n"
                "output both = spring.along.x + spring.k\n") ==
        "system model\n"
        "dimension 2\n"
        "\n"
        "parameters\n"
        "  spring.damping = 10\n"
        "\n"
        "expressions used more than once\n"
        "  $1 = 0 - weight[2].bob.x\n"
        "  $2 = 0 - weight[2].bob.y\n"
        "  $3 = 5*(sqrt($1^2 + $2^2) - 1) - spring.damping\n"
        "\n"
        "coordinates\n"
        "  weight[1].bob.x: starts at 0\n"
        "  weight[1].bob.y: starts at 0\n"
        "  weight[2].bob.x: starts at 0\n"
        "  weight[2].bob.y: starts at 0\n"
        "\n"
        "speeds\n"
        "  weight[1].bob.vx: starts at 0, inertia 3\n"
        "  weight[1].bob.vy: starts at 0, inertia 3\n"
        "  weight[2].bob.vx: starts at 0, inertia 6\n"
        "  weight[2].bob.vy: starts at 0, inertia 6\n"
        "\n"
        "forces\n"
        "  force on `spring.here`, x: $3*$1 along weight[2].bob.x'\n"
        "  force on `spring.here`, y: $3*$2 along weight[2].bob.y'\n"
        "\n"
        "constraints\n"
        "  weight[1].constraint_1: weight[1].bob.x = 0   (holonomic, in a loop at 1)\n"
        "  weight[1].pin: weight[1].bob.y = 0   (holonomic, in a loop at 1)\n"
        "  weight[2].constraint_1: weight[2].bob.x = 0   (holonomic, in a loop at 2)\n"
        "  weight[2].pin: weight[2].bob.y = 0   (holonomic, in a loop at 2)\n"
        "\n"
        "outputs\n"
        "  spring.length = sqrt($1^2 + $2^2)\n"
        "  both = $1 + 5\n");
}

TEST_CASE("constraints of parts share the statement of their module, and tell the passes around the part") {
  const model::System system = system_of(
      "dimension 1\nmodule Pair() { for j in 1..2 { particle p[j] { mass = 1; position = 0 }\n"
      "constraint c[j] : p[j].x = 0 } }\n"
      "for i in 1..2 { part pair[i] = Pair() }\npart last = Pair()\n");
  REQUIRE(system.constraints.size() == 6);
  CHECK(system.constraints[3].name == "pair[2].c[2]");
  REQUIRE(system.constraints[3].made_by);
  CHECK(system.constraints[3].made_by->indices == std::vector<long>{2, 2});
  CHECK(system.constraints[4].made_by->indices == std::vector<long>{1});
  CHECK(system.constraints[4].made_by->statement == system.constraints[2].made_by->statement);
}

TEST_CASE("settings of a module count where it runs alone") {
  const std::string swing =
      "module Swing(L = 2) {\n  dimension 2\n  gravity (0, -10)\n"
      "  particle seat { mass = L; position = (L, 0) }\n  integrate { to = L; method = rk4 }\n}\n";
  const model::System alone = system_of(swing);
  CHECK(alone.dimension == 2);
  CHECK(alone.coordinates[0].name == "seat.x");
  REQUIRE(alone.forces.size() == 1);
  CHECK(alone[alone.forces[0].value].number == -20);
  CHECK(alone.integration.to == 2.0);

  const model::System part = system_of("dimension 2\npart swing = Swing(L = 3)\n" + swing);
  CHECK(part.coordinates[0].name == "swing.seat.x");
  CHECK(part.forces.empty());
  CHECK_FALSE(part.integration.to);
  CHECK_FALSE(part.integration.method);
}

TEST_CASE("of several modules the one runs alone that is not a part of another") {
  const std::string inner = "module Bob(m = 1) { particle bob { mass = m; position = 0 } }\n";
  CHECK(system_of("dimension 1\n" + inner + "module Two() { for i in 1..2 { part one[i] = Bob(m = i) } }\n")
            .coordinates[1]
            .name == "one[2].bob.x");
  const auto imported = resolve_files({{"all.mbd", "import \"bob.mbd\"\nmodule All() { part first = Bob() }\n"},
                                       {"bob.mbd", "dimension 1\n" + inner + "module Other() {}\n"}},
                                      "all.mbd");
  CHECK(imported.messages().empty());
  REQUIRE(imported.system);
  CHECK(imported.system->coordinates[0].name == "first.bob.x");
  CHECK(system_of(inner + "module Other() {}\n").coordinates.empty());
}

TEST_CASE("a force on a point acts along the velocity of the point") {
  CHECK(printed("dimension 2\nparticle a { mass = 1; position = 0 }\nparticle b { mass = 1; position = 0 }\n"
                "point between = (3*a.position + b.position)/4\nforce on between = (0, t)\nforce on fixed = (1, 1)\n"
                "point fixed = (1, t)\noutput pace = between.vy\n")
            .find("forces\n"
                  "  force on `between`, y: t along $1'\n") != std::string::npos);
}

}  // namespace
}  // namespace mbcc
