// Mechanisms with closed loops, redundant conditions and prescribed motions: published tables and a quadrature.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {

TEST_CASE("whitworth: published motion of slider and lever") {
  struct Row {
    double t, x, vx, lever;
  };
  const Row rows[] = {{0.0, 0.80000000, -0.25587632, 0.46199892},
                      {0.5, 0.65539709, -0.31124132, 0.50324739},
                      {1.0, 0.50000000, -0.29852238, 0.46199892},
                      {1.5, 0.37238504, -0.18825618, 0.28559933},
                      {2.0, 0.35711412, 0.20762895, -0.31415927}};
  const Run run = run_example("whitworth");
  const double printed = 1e-8;  // the table's last digit; the integration is better
  for (const Row& row : rows) {
    INFO(row.t);
    CHECK(run.table.at(row.t, "slider.x") == near(row.x, printed));
    CHECK(run.table.at(row.t, "slider.vx") == near(row.vx, printed));
    CHECK(run.table.at(row.t, "lever_turns") == near(row.lever, printed));
  }
  // The crank has turned once: everything is where it was. Independent RK4 at the same step: 0.79999999998.
  CHECK(run.table.last("slider.x") == near(0.8, 1e-10));
  CHECK(run.table.at(2.5, "slider.vx") == near(0.8663749671, 1e-10));
}

TEST_CASE("slider-crank: published motion of the crank") {
  struct Row {
    double t, s, angle, rate;
  };
  const Row rows[] = {{0.0, -0.04142136, 0.69333812, 0},
                      {0.05, -0.07306446, 0.93058885, 8.18635917},
                      {0.125, -0.20710678, 1.65668834, 10.09029387},
                      {0.15, -0.25830639, 1.90472502, 9.69083138},
                      {0.25, -0.37279221, 2.55148920, 0},
                      {0.375, -0.20710678, 1.65668834, -10.09029387},
                      {0.5, -0.04142136, 0.69333812, 0}};
  const Table table = run_example("slider_crank").table;
  const double printed = 1e-8;  // the table's last digit
  for (const Row& row : rows) {
    INFO(row.t);
    CHECK(table.at(row.t, "slider.x") == near(row.s, printed));
    CHECK(table.at(row.t, "crank_angle") == near(row.angle, printed));
    CHECK(table.at(row.t, "crank_rate") == near(row.rate, 10 * printed));  // rates are ten times larger
  }
}

TEST_CASE("ring and disc: published motion, with a redundant condition") {
  struct Row {
    double t, theta, theta_rate, ring, disc, normal;
  };
  const Row rows[] = {{0.5, 0.810007770, -1.255767192, -1.941779928, -9.402723209, 0.102863793},
                      {1.0, 0.228205738, -0.721573978, -3.992374238, -14.991586740, 0.325043614},
                      {2.0, 0.883812829, 1.173400697, -8.122262704, -24.336274054, -0.035704332}};
  const Run run = run_example("ring_and_disc");
  const double printed = 1e-9;  // the table's last digit
  for (const Row& row : rows) {
    INFO(row.t);
    CHECK(run.table.at(row.t, "theta") == near(row.theta, printed));
    CHECK(run.table.at(row.t, "theta_rate") == near(row.theta_rate, printed));
    CHECK(run.table.at(row.t, "ring_angle.vx") == near(row.ring, printed));
    CHECK(run.table.at(row.t, "disc_angle.vx") == near(row.disc, printed));
    CHECK(run.table.at(row.t, "normal.vx") == near(row.normal, printed));
  }
  CHECK(run.errors.find("redundant: rank 3 of 4") != std::string::npos);
}

namespace {

/// The four-bar as a system of one coordinate, the crank's angle: the energy integral gives its rate.
struct FourBar {
  double energy;

  [[nodiscard]] double rate(double angle) const {
    const double x1 = std::cos(angle), y1 = std::sin(angle);
    // The rocker's end lies 2.5 from the crank's end and from (2, 0), to the left of the line that joins them.
    const double dx = 2 - x1, dy = -y1;
    const double base = std::hypot(dx, dy);
    const double rise = std::sqrt(2.5 * 2.5 - base * base / 4);
    const double x2 = x1 + dx / 2 - rise * dy / base, y2 = y1 + dy / 2 + rise * dx / base;
    // Its velocity per crank rate is across the rocker, and as fast along the coupler as the crank's end.
    const double ux = -y2, uy = x2 - 2;
    const double along_coupler = ((x2 - x1) * -y1 + (y2 - y1) * x1) / ((x2 - x1) * ux + (y2 - y1) * uy);
    const double speed2 = along_coupler * along_coupler * (ux * ux + uy * uy);
    return std::sqrt(2 * (energy - 9.81 * (y1 + y2)) / (1 + speed2));
  }

  /// Time to turn by `angle` from the top, by Simpson's rule.
  [[nodiscard]] double time(double angle) const {
    const int intervals = 200000;  // error below 1e-13
    const double h = angle / intervals;
    double sum = 0;
    for (int i = 0; i <= intervals; ++i) {
      const double weight = i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight / rate(std::acos(-1.0) / 2 - i * h);
    }
    return sum * h / 3;
  }
};

}  // namespace

TEST_CASE("four-bar: the angle that the crank turns takes the time that a quadrature gives") {
  const Run run = run_example("four_bar");
  const std::vector<double>& x = run.table["crank.x"];
  const std::vector<double>& y = run.table["crank.y"];
  double turned = 0;  // clockwise
  for (std::size_t row = 1; row < run.table.rows(); ++row) {
    turned -= std::atan2(x[row - 1] * y[row] - y[row - 1] * x[row], x[row - 1] * x[row] + y[row - 1] * y[row]);
  }
  const FourBar four_bar{0.5 + 0.5 + 9.81 * 3.5};
  CHECK(turned > 4 * std::acos(-1.0));  // it turns for ever
  // RK4's end error, about 1e-8 rad, divided by the crank's rate there, at least 1 rad/s.
  CHECK(four_bar.time(turned) == near(10, 1e-7));
  CHECK(run.summary["energy"]["max_drift"].get<double>() < 1e-7);
}

}  // namespace mbcc::test
