// Motion without constraints: Kepler's ellipse and the figure of eight.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {
namespace {

/// Largest distance from the ellipse of semi-axis 1 about a sun of parameter 1, by Kepler's equation.
double kepler_error(double e, const Table& table) {
  double largest = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double mean = table["t"][row];
    double anomaly = mean;
    for (int iteration = 0; iteration < 50; ++iteration) {  // Newton; converges from the mean anomaly for small e
      anomaly -= (anomaly - e * std::sin(anomaly) - mean) / (1 - e * std::cos(anomaly));
    }
    const double dx = table["planet.x"][row] - (std::cos(anomaly) - e);
    const double dy = table["planet.y"][row] - std::sqrt(1 - e * e) * std::sin(anomaly);
    largest = std::max(largest, std::hypot(dx, dy));
  }
  return largest;
}

}  // namespace

TEST_CASE("kepler: the ellipse at all times, order four, invariants") {
  const double error = kepler_error(0.3, run_example("kepler", {"--step", "0.01"}).table);
  const double error_at_half = kepler_error(0.3, run_example("kepler", {"--step", "0.005"}).table);
  CHECK(observed_order(error, error_at_half) == near(4, 0.2));

  const Run run = run_example("kepler");
  CHECK(kepler_error(0.3, run.table) < 2e-3 * error);  // steps five times smaller
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    REQUIRE(run.table["orbital_energy"][row] == near(-0.5, 1e-10));
    REQUIRE(run.table["angular_momentum"][row] == near(std::sqrt(1 - 0.3 * 0.3), 1e-10));
  }
}

TEST_CASE("kepler: a parameter makes another ellipse") {
  CHECK(kepler_error(0, run_example("kepler", {"--set", "eccentricity=0"}).table) < 1e-10);
}

TEST_CASE("three bodies: they come back after one period, one after another along the same eight") {
  const Run run = run_example("three_bodies");
  const std::vector<std::string> quantities = {"x", "y", "vx", "vy"};
  for (const std::string body : {"p[1].", "p[2].", "p[3]."}) {
    for (const std::string& quantity : quantities) {
      INFO(body << quantity);
      // The start is known to 14 digits; RK4 at this step is 5e-12 off after a period, in an independent integration.
      CHECK(run.table.last(body + quantity) == near(run.table[body + quantity].front(), 1e-10));
    }
  }
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    REQUIRE(run.table["angular_momentum"][row] == near(0, 1e-10));
    REQUIRE(run.table["total_energy"][row] == near(run.table["total_energy"].front(), 1e-10));
  }
  const Table third = run_example("three_bodies", {"--to", flag(6.32591398292621 / 3)}).table;
  CHECK(third.last("p[2].x") == near(third["p[1].x"].front(), 1e-10));
  CHECK(third.last("p[3].y") == near(third["p[2].y"].front(), 1e-10));
}

}  // namespace mbcc::test
