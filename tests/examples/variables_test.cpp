// Systems in variables of their own: published end states, other descriptions of the same system, closed forms.

#include <catch2/catch.hpp>
#include <cmath>

#include "example.hpp"

namespace mbcc::test {

TEST_CASE("pendulum by its angle: quadruple-precision end state") {
  const Run run = run_example("pendulum_angle");
  CHECK(run.summary["fallbacks"] == 0);
  // The angle is determined to a rounding of the start times the growth of errors in 100 s, a few hundred.
  CHECK(run.table.last("theta") == near(-1.55614066649660836561, 3e-11));
  CHECK(run.table.last("theta'") == near(-4.00074636770110263475, 3e-11));
}

TEST_CASE("double pendulum: angles and particles describe one motion") {
  // Both are accurate to about 1e-12 over these two seconds, in which errors grow less than a hundredfold.
  const std::vector<std::string> flags = {"--method", "dop853", "--tolerance", "1e-13", "--every", "0.1", "--to", "2"};
  const Table angles = run_example("double_pendulum_angles", flags).table;
  const Table particles = run_example("double_pendulum", flags).table;
  REQUIRE(angles.rows() == particles.rows());
  for (const std::string column : {"upper.x", "upper.y", "lower.x", "lower.y"}) {
    for (std::size_t row = 0; row < angles.rows(); ++row) {
      REQUIRE(angles[column][row] == near(particles[column][row], 1e-10));
    }
  }
}

TEST_CASE("spherical pendulum: two descriptions, the published end state, energy and spin") {
  const Run angles = run_example("spherical_pendulum_angles");
  const Run square = run_example("spherical_pendulum_speed");
  CHECK(angles.table.last("bob.x") == near(0.83156816, 5e-9));  // to its printed digits
  CHECK(angles.table.last("bob.y") == near(-0.13471184, 5e-9));
  CHECK(angles.table.last("bob.z") == near(-0.53883867, 5e-9));
  for (const std::string column : {"bob.x", "bob.y", "bob.z"}) {
    CHECK(angles.table.last(column) == near(square.table.last(column), 1e-10));  // tolerance 1e-12, some 200 steps
  }
  CHECK(angles.table.last("spin") == near(0.9, 1e-10));
  CHECK(angles.summary["energy"]["initial"].get<double>() == near(-6.715, 1e-14));
  CHECK(angles.summary["energy"]["max_drift"].get<double>() < 1e-10);
  for (const double energy : square.table["energy_by_square"]) {
    REQUIRE(energy == near(-6.715, 1e-10));
  }
}

TEST_CASE("a speed without inertia is projected, stabilized and assembled like others") {
  const std::vector<std::string> steps = {"--method", "rk4", "--step", "0.001"};
  const auto with = [&steps](std::vector<std::string> flags) {
    flags.insert(flags.end(), steps.begin(), steps.end());
    return run_example("spherical_pendulum_speed", flags);
  };
  for (const Run& run : {with({"--project", "on"}), with({"--stabilize", "1,1,1"})}) {
    CHECK(run.table.last("bob.x") == near(0.83156816, 1e-8));  // rk4 at this step, and the printed digits
    CHECK(run.summary["constraints"]["definition"]["velocity"].get<double>() < 1e-10);
  }
  const Table off = with({"--assemble", "--initial", "bob.x=0.9", "--fix", "square", "--to", "0"}).table;
  const auto at = [&off](const std::string& column) { return off[column].front(); };
  CHECK(at("bob.x") == 0.9);
  CHECK(at("square") == 2.25);
  CHECK(std::hypot(at("bob.x"), at("bob.y"), at("bob.z")) == near(1, 1e-14));
  CHECK(std::hypot(at("bob.vx"), at("bob.vy"), at("bob.vz")) == near(1.5, 1e-14));
}

TEST_CASE("cart and pendulum: no momentum along the rail, energy conserved") {
  const Run run = run_example("cart_pendulum");
  CHECK(run.summary["energy"]["max_drift"].get<double>() < 1e-10);
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    REQUIRE(run.table["momentum"][row] == near(0, 1e-10));
    REQUIRE(2 * run.table["x"][row] + run.table["bob.x"][row] == near(0.5 * std::sin(2.0), 1e-10));
  }
}

TEST_CASE("wheel with a motor: closed form of two linear equations") {
  const Table table = run_example("motor_wheel", {"--every", "0.05"}).table;
  // v'' + (R/L) v' + k^2/(r^2 M L) v = k U/(r M L), M = m + J/r^2; at rest in the beginning
  const double mass = 2 + 0.02 / (0.1 * 0.1);
  const double damping = 0.5 * 1 / 0.05;
  const double stiffness = 0.25 / (0.01 * mass * 0.05);
  const double frequency = std::sqrt(stiffness - damping * damping);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t = table["t"][row];
    const double fading = std::exp(-damping * t);
    const double v = 2.4 * (1 - fading * (std::cos(frequency * t) + damping / frequency * std::sin(frequency * t)));
    const double acceleration = 2.4 * stiffness / frequency * fading * std::sin(frequency * t);
    REQUIRE(table["v"][row] == near(v, 1e-11));
    REQUIRE(table["i"][row] == near(mass * 0.1 / 0.5 * acceleration, 1e-10));
    REQUIRE(table["theta"][row] == near(10 * table["x"][row], 1e-12));
  }
}

}  // namespace mbcc::test
