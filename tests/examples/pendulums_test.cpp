// The pendulums: closed forms, published end states and invariants.

#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {
namespace {

/// Largest difference from the closed form of a pendulum released at rest, in elliptic functions.
double pendulum_error(double length, double g, double start, const Table& table) {
  const double modulus = std::sin(start / 2);
  double largest = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    double cn = 0, dn = 0;
    boost::math::jacobi_elliptic(modulus, std::sqrt(g / length) * table["t"][row], &cn, &dn);
    largest = std::max(largest, std::abs(table["angle"][row] - 2 * std::asin(modulus * cn / dn)));
  }
  return largest;
}

}  // namespace

TEST_CASE("planar pendulum: closed form at all times, order four") {
  const double third = std::acos(0.5);
  const double error = pendulum_error(1, 9.81, third, run_example("planar_pendulum", {"--step", "0.02"}).table);
  const double at_half = pendulum_error(1, 9.81, third, run_example("planar_pendulum", {"--step", "0.01"}).table);
  CHECK(observed_order(error, at_half) == near(4, 0.2));  // steps are a hundredth of the period
  // As it stands, with a step ten times smaller than the first, the error is ten thousand times smaller.
  CHECK(pendulum_error(1, 9.81, third, run_example("planar_pendulum").table) < 2e-4 * error);
}

TEST_CASE("planar pendulum: parameters are set when it runs") {
  const Table table =
      run_example("planar_pendulum", {"--set", "length=2", "--set", "g=1.62", "--set", "start=2"}).table;
  CHECK(table["bob.x"].front() == near(2 * std::sin(2.0), 1e-15));
  CHECK(pendulum_error(2, 1.62, 2, table) < 1e-9);  // slower than the one above, so at least as accurate
}

TEST_CASE("spherical pendulum: reference end state and invariants") {
  const Run run = run_example("spherical_pendulum");
  // Reference in quadruple precision. The error of RK4 at this step is a few 1e-10, judged by halving it.
  CHECK(run.table.last("bob.x") == near(-4.6625812033662674e-2, 1e-9));
  CHECK(run.table.last("bob.y") == near(4.0419188477692606e-1, 1e-9));
  CHECK(run.table.last("bob.z") == near(-9.134850595016197e-1, 1e-9));
  CHECK(run.summary["energy"]["initial"].get<double>() == near(0.5 - 9.81 * 0.8, 1e-14));
  CHECK(observed_order(energy_drift("spherical_pendulum", "0.002"), energy_drift("spherical_pendulum", "0.001")) ==
        near(4, 0.1));
  for (const double spin : run.table["spin"]) {
    REQUIRE(spin == near(0.6, 1e-10));  // neither weight nor rod has a moment about the vertical
  }
}

TEST_CASE("double pendulum: quadruple-precision end state of the chaotic motion, energy conserved") {
  const Run run = run_example("double_pendulum");
  CHECK(run.summary["energy"]["max_drift"].get<double>() < 1e-7);
  const nlohmann::json end = nlohmann::json::parse(
      read_file(std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models/references.json"))["double_pendulum"]["end"];
  const double tolerance = 1e-6;  // RK4 at this step is 4e-7 off, by an independent integration
  CHECK(run.table.last("upper.x") == near(end["x1"], tolerance));
  CHECK(run.table.last("upper.y") == near(end["y1"], tolerance));
  CHECK(run.table.last("lower.x") == near(end["x2"], tolerance));
  CHECK(run.table.last("lower.y") == near(end["y2"], tolerance));
}

}  // namespace mbcc::test
