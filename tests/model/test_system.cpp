#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>

#include "model/columns.hpp"
#include "resolved.hpp"

namespace mbcc {
namespace {

using model::index;
using test::printed;
using test::resolve_text;
using test::system_of;

TEST_CASE("the paper's example, resolved") {
  CHECK(printed(
            "system artigo5\n"
            "dimension 3\n"
            "particle 1 { mass = 1; position = (1, 0, 0.5); velocity = (0, pi, 0); force = (-9.81*x1, 0, -9.81*z1) }\n"
            "particle 2 { mass = 1; position = (2, 1, -0.75) }\n"
            "constraint sphere : x1^2 + y1^2 + z1^2 = 1\n"
            "constraint : x1*sin(2*pi*t) = y1*cos(2*pi*t)\n"
            "constraint : z2*vx2 - vy2\n"
            "integrate { from = 0; to = 5; step = 0.005; method = rk4 }\n") ==
        "system artigo5\n"
        "dimension 3\n"
        "\n"
        "coordinates\n"
        "  x1: starts at 1\n"
        "  y1: starts at 0\n"
        "  z1: starts at 0.5\n"
        "  x2: starts at 2\n"
        "  y2: starts at 1\n"
        "  z2: starts at -0.75\n"
        "\n"
        "speeds\n"
        "  vx1: starts at 0, inertia 1\n"
        "  vy1: starts at 3.141592653589793, inertia 1\n"
        "  vz1: starts at 0, inertia 1\n"
        "  vx2: starts at 0, inertia 1\n"
        "  vy2: starts at 0, inertia 1\n"
        "  vz2: starts at 0, inertia 1\n"
        "\n"
        "forces\n"
        "  force on particle 1, x: -9.81*x1 along vx1\n"
        "  force on particle 1, z: -9.81*z1 along vz1\n"
        "\n"
        "constraints\n"
        "  sphere: x1^2 + y1^2 + z1^2 - 1 = 0   (holonomic)\n"
        "  constraint_2: x1*sin(6.283185307179586*t) - y1*cos(6.283185307179586*t) = 0   (holonomic)\n"
        "  constraint_3: z2*vx2 - vy2 = 0   (nonholonomic)\n"
        "\n"
        "integrate\n"
        "  from = 0\n"
        "  to = 5\n"
        "  step = 0.005\n"
        "  method = rk4\n");
}

TEST_CASE("coordinates come in order of declaration, and know their speeds") {
  const model::System system = system_of(
      "dimension 2\n"
      "particle 2 { mass = 1; position = (0, 0) }\n"
      "particle bob { mass = 1; position = (0, 0) }\n"
      "for i in 1..1 { particle i { mass = 1; position = (0, 0) } }\n");
  std::string names;
  for (const model::Coordinate& coordinate : system.coordinates) {
    const model::Speed& speed = system[*system.speed_of(coordinate)];
    names += coordinate.name + " " + speed.name + " " + speed.acceleration + "; ";
  }
  CHECK(names == "x2 vx2 ax2; y2 vy2 ay2; bob.x bob.vx bob.ax; bob.y bob.vy bob.ay; x1 vx1 ax1; y1 vy1 ay1; ");
}

TEST_CASE("many particles are stored axis by axis, and shown in order of declaration") {
  const auto names_of = [](int particles) {
    const model::System system =
        system_of(fmt::format("dimension 2\nfor i in 1..{} {{ particle p[i] {{ mass = 1; position = (i, 0) }} }}\n"
                              "force on p[3] = (0, p[2].vx)\n",
                              particles));
    CHECK(system.speeds[system[system.forces[0].along].index].name == "p[3].vy");
    std::string stored, declared;
    for (const model::Coordinate& coordinate : system.coordinates) {
      stored += coordinate.name + " " + system[*system.speed_of(coordinate)].name + "; ";
    }
    for (const model::CoordinateId id : system.declared_coordinates) {
      declared += system[id].name + " ";
    }
    CHECK(model::columns(system).size() == (particles < 16 ? 0 : 4 * static_cast<std::size_t>(particles)));
    return std::pair(stored, declared);
  };
  CHECK(names_of(15).first.find("p[1].x p[1].vx; p[1].y p[1].vy; p[2].x p[2].vx; ") == 0);
  CHECK(names_of(16).first.find("p[1].x p[1].vx; p[2].x p[2].vx; p[3].x p[3].vx; ") == 0);
  CHECK(names_of(15).second.find("p[1].x p[1].y p[2].x p[2].y ") == 0);
  CHECK(names_of(16).second.find("p[1].x p[1].y p[2].x p[2].y ") == 0);
}

TEST_CASE("in dimension 1 positions, velocities, forces and gravity are plain numbers") {
  CHECK(printed("dimension 1\nparticle bob { mass = 2; position = 1; velocity = 3; force = -bob.position }\n"
                "gravity -10\nforce on bob = bob.velocity^2\nconstraint : norm(bob.position)^2 = t^2\n")
            .find("forces\n"
                  "  force on `bob`: -bob.x along bob.vx\n"
                  "  gravity on `bob`: -20 along bob.vx\n"
                  "  force on `bob`: bob.vx^2 along bob.vx\n"
                  "\n"
                  "constraints\n"
                  "  constraint_1: bob.x^2 - t^2 = 0   (holonomic)\n") != std::string::npos);
}

TEST_CASE("forces add up, and those that are zero are none") {
  CHECK(printed("parameter g = 10\nparticle 1 { mass = m; position = (0, 0, 0); force = 0 }\nparameter m = 2\n"
                "particle p[1] { mass = 3; position = (0, 0, 0); force = (0, t, 0) }\n"
                "gravity (0, 0, -g)\nfor i in 1..1 { force on i = i*(1, 0, 0)\nforce on p[i] = 2*p[i].velocity }\n")
            .find("forces\n"
                  "  force on `p[1]`, y: t along p[1].vy\n"
                  "  gravity on particle 1, z: m*$1 along vz1\n"
                  "  gravity on `p[1]`, z: 3*$1 along p[1].vz\n"
                  "  force on particle 1, x: 1 along vx1\n"
                  "  force on `p[1]`, x: 2*p[1].vx along p[1].vx\n"
                  "  force on `p[1]`, y: 2*p[1].vy along p[1].vy\n"
                  "  force on `p[1]`, z: 2*p[1].vz along p[1].vz\n") != std::string::npos);
}

TEST_CASE("a mass is judged where the parameters have their defaults") {
  const std::string rest = "; position = (0, 0, 0) }\n";
  CHECK(resolve_text("parameter a = 3\nlet b = a*a - 8\nparticle 1 { mass = b" + rest).system);
  CHECK_FALSE(resolve_text("parameter a = 3\nlet b = a*a - 9\nparticle 1 { mass = b" + rest).system);
  CHECK_FALSE(resolve_text("parameter a = -3\nparticle 1 { mass = sqrt(a)" + rest).system);
}

TEST_CASE("unnamed constraints count all constraints, loops expanded; vector equations are one with rows") {
  const model::System system = system_of(
      "particle 1 { mass = 1; position = (0, 0, 0) }\n"
      "particle p { mass = 1; position = (0, 0, 0) }\n"
      "for i in 1..2 { constraint c[i] : x1 = i*y1 }\n"
      "constraint : p.position = (0, 0, 0)\n"
      "constraint pin : p.velocity = 0\n"
      "constraint : x1' = 0\n");
  std::string names;
  for (const model::Constraint& constraint : system.constraints) {
    names += constraint.name + (constraint.holonomic ? " " : "' ");
  }
  CHECK(names == "c[1] c[2] constraint_3.x constraint_3.y constraint_3.z pin.x' pin.y' pin.z' constraint_5' ");
}

TEST_CASE("constraints remember their text and the loop passes that made them") {
  const model::System system = system_of(
      "dimension 1\nparticle 1 { mass = 1; position = 0 }\n"
      "for i in 1..2 { for j in i..2 {\n"
      "  constraint c[i, j] : x1 =   # a remark\n"
      "    i +\n"
      "    j\n"
      "} }\n"
      "constraint d : x1 = 0\n");
  REQUIRE(system.constraints.size() == 4);
  const model::Constraint& second = system.constraints[1];
  CHECK(second.name == "c[1,2]");
  CHECK(second.text == "x1 = i + j");
  REQUIRE(second.made_by);
  CHECK(second.made_by->indices == std::vector<long>{1, 2});
  CHECK(second.made_by->statement == system.constraints[2].made_by->statement);
  CHECK_FALSE(system.constraints[3].made_by);
}

TEST_CASE("a side that is zero leaves the other") {
  CHECK(printed("dimension 1\nparticle 1 { mass = 1; position = 0 }\nconstraint a : x1 = 0\nconstraint b : vx1\n"
                "constraint c : x1 = vx1\n")
            .find("constraints\n"
                  "  a: x1 = 0   (holonomic)\n"
                  "  b: vx1 = 0   (nonholonomic)\n"
                  "  c: x1 - vx1 = 0   (nonholonomic)\n") != std::string::npos);
}

TEST_CASE("a vector output has a column for each component") {
  const model::System system =
      system_of("dimension 2\nparticle p { mass = 1; position = (0, 0) }\noutput a = p.velocity'\noutput b = p.x\n");
  REQUIRE(system.outputs.size() == 3);
  CHECK(system.outputs[0].name == "a.x");
  CHECK(system.outputs[1].name == "a.y");
  CHECK(system.outputs[2].name == "b");
}

TEST_CASE("operands come before what uses them, and nothing is left over") {
  const model::System system =
      system_of("particle 1 { mass = 1; position = (0, 0, 0) }\nlet r = norm((x1, y1, z1))\nconstraint : r^2 = 1\n");
  std::vector<int> uses(system.expressions.size());
  const auto use = [&](model::ExpressionId id) { ++uses[index(id)]; };
  for (std::size_t i = 0; i < system.expressions.size(); ++i) {
    const model::Expression& expression = system.expressions[i];
    const bool applies = expression.kind == model::ExpressionKind::Apply;
    for (std::size_t k = 0; applies && k < static_cast<std::size_t>(graph::arity(expression.op)); ++k) {
      CHECK(index(expression.operands[k]) < i);
      use(expression.operands[k]);
    }
  }
  for (std::size_t i = 0; i < system.coordinates.size(); ++i) {
    use(system.coordinates[i].rate);
    use(system.coordinates[i].initial);
    use(system.speeds[i].initial);
    use(system.speeds[i].inertia);
  }
  use(system.constraints[0].value);
  CHECK(std::count(uses.begin(), uses.end(), 0) == 0);
}

TEST_CASE("large models stay affordable") {
  const std::string bodies =
      "constant N = 300\n"
      "for i in 1..N { particle p[i] { mass = 1; position = (i, 0, 0)\n"
      "  force = sum(j in 1..N, if(j != i, (p[j].position - p[i].position)/norm(p[j].position - p[i].position)^3, 0)) "
      "} }\n";
  const auto start = std::chrono::steady_clock::now();
  const model::System system = system_of(bodies);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  CHECK(system.forces.size() == 900);
  CHECK(taken.count() < 10);  // 0.3 s here; a cost that grows faster than the number of terms would take minutes
}

}  // namespace
}  // namespace mbcc
