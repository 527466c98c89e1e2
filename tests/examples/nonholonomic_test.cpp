// Conditions on velocities, and conditions that move with time.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {
namespace {

const double pi = std::acos(-1.0);

/// Largest difference of the skate's middle from its closed form, a cycloid across the slope.
double skate_error(double gravity_along, double spin, const Table& table) {
  const double a = gravity_along / (2 * spin * spin);
  double largest = 0;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double turned = spin * table["t"][row];
    largest = std::max({largest, std::abs(table["down"][row] - a * std::pow(std::sin(turned), 2)),
                        std::abs(table["across"][row] - a * (turned - std::sin(2 * turned) / 2))});
  }
  return largest;
}

}  // namespace

TEST_CASE("skate: closed form at all times, order four") {
  const double along = 9.81 * std::sin(pi / 4);
  const double error = skate_error(along, pi / 3, run_example("skate", {"--step", "0.02"}).table);
  const double error_at_half = skate_error(along, pi / 3, run_example("skate", {"--step", "0.01"}).table);
  CHECK(observed_order(error, error_at_half) == near(4, 0.2));
  CHECK(skate_error(along, pi / 3, run_example("skate").table) < 1e-10);  // where it goes 30 m

  const Table other = run_example("skate", {"--set", "slope=0.3", "--set", "spin=2", "--set", "reach=0.1"}).table;
  CHECK(skate_error(9.81 * std::sin(0.3), 2, other) < 1e-9);
}

TEST_CASE("constant speed: closed form at all times, order four") {
  const auto largest_error = [](double pace, const Table& table) {
    double largest = 0;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double s = 9.81 * table["t"][row] / pace;
      const double x = pace * pace / 9.81 * 2 * std::atan(std::tanh(s / 2));  // the gudermannian
      const double y = -pace * pace / 9.81 * std::log(std::cosh(s));
      largest = std::max({largest, std::abs(table["p.x"][row] - x), std::abs(table["p.y"][row] - y),
                          std::abs(std::sin(table["heading"][row]) + std::tanh(s))});
    }
    return largest;
  };
  const double error = largest_error(1, run_example("constant_speed", {"--step", "0.01"}).table);
  const double error_at_half = largest_error(1, run_example("constant_speed", {"--step", "0.005"}).table);
  CHECK(observed_order(error, error_at_half) == near(4, 0.3));  // a tenth of the time in which the path turns
  CHECK(largest_error(1, run_example("constant_speed").table) < 2e-5 * error);  // steps twenty times smaller
  CHECK(largest_error(3, run_example("constant_speed", {"--set", "pace=3"}).table) < 1e-10);
}

namespace {

/// The bead's angle in the hoop at the end, from its own equation of one coordinate: angle'' = (w^2 cos - g/R) sin.
double hoop_angle(double radius, double turn, double angle, double to) {
  const int steps = 40000;  // error about 1e-14
  const double h = to / steps;
  const auto acceleration = [&](double a) { return (turn * turn * std::cos(a) - 9.81 / radius) * std::sin(a); };
  double rate = 0;
  for (int step = 0; step < steps; ++step) {  // Runge-Kutta-Nystrom of order four
    const double k1 = acceleration(angle);
    const double k2 = acceleration(angle + h / 2 * rate + h * h / 8 * k1);
    const double k3 = acceleration(angle + h * rate + h * h / 2 * k2);
    angle += h * rate + h * h / 6 * (k1 + 2 * k2);
    rate += h / 6 * (k1 + 4 * k2 + k3);
  }
  return angle;
}

}  // namespace

TEST_CASE("bead on a hoop: the motion of one coordinate, order four") {
  const double exact = hoop_angle(0.5, 6, 0.2, 10);
  const auto error = [&](const std::string& step) {
    return std::abs(run_example("bead_on_hoop", {"--step", step}).table.last("angle") - exact);
  };
  const double fine = error("0.001");
  CHECK(observed_order(error("0.002"), fine) == near(4, 0.2));
  CHECK(fine < 2e-7);  // a start near the unstable lowest point magnifies errors
}

TEST_CASE("bead on a hoop: it rests where weight and turning balance") {
  const double balance = std::acos(9.81 / (0.5 * 6 * 6));
  const Table table = run_example("bead_on_hoop", {"--set", "start=" + flag(balance)}).table;
  for (const double angle : table["angle"]) {
    REQUIRE(angle == near(balance, 1e-9));
  }
}

}  // namespace mbcc::test
