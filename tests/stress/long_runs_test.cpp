// A pendulum for up to a million periods: constraints, energy and phase.
//
// A swing from the angle a has the period 4 K(sin(a/2))/w. Steps err by the tolerance, and by rounding: a random walk
// of some eps at each step in the energy, E ~ eps sqrt(n) after n steps. The phase integrates the error of the
// frequency, w' E with w' = dw/dE of order 1: a walk's integral is eps n^1.5 times the time of a step over sqrt(3).

#include "closed_forms.hpp"
#include "runs.hpp"

namespace mbcc::test {
namespace {

const double w = std::sqrt(9.81);

/// The planar pendulum from pi/3 for so many periods, with one row at the end alone.
Run swing(double periods, const std::string& method, double tolerance, double start = std::acos(0.5),
          const std::string& project = "on") {
  const std::string to = flag(periods * Swing{start, w}.period());
  return completed(example_model("planar_pendulum"), method, tolerance,
                   {"--to", to, "--every", to, "--set", "start=" + flag(start), "--project", project});
}

void check_phase(double periods) {
  const Run run = swing(periods, "taylor", 1e-15);
  const double steps = run.summary["steps"];
  // After whole periods the bob turns round: its place is off by the square of the phase's error, its speed by the
  // acceleration there, 9.81 sin(pi/3), times the error in time.
  const double late = run.final_value("bob.vx") / (9.81 * std::sin(std::acos(0.5)) * 0.5);
  const double step = periods * Swing{std::acos(0.5), w}.period() / steps;
  const double walk = 4 * eps * std::pow(steps, 1.5) * step / std::sqrt(3.0);
  // The time itself is a sum of steps, rounded at its size: another walk. The end time is rounded by no more than eps.
  const double clock = 4 * eps * std::sqrt(steps) * periods * Swing{std::acos(0.5), w}.period();
  CAPTURE(steps, late, walk, clock);
  CHECK(std::abs(late) < walk + clock);
  // Energy: the walk, four times its deviation; of 9.81 in units of w^2.
  const double drift = run.summary["energy"]["max_drift"];
  CHECK(drift < 4 * eps * std::sqrt(steps) * 9.81);
  CHECK(run.constraint_error("rod", "position") < 4 * eps);
  CHECK(run.constraint_error("rod", "velocity") < 16 * eps);  // of speeds up to 3.2
}

/// |E - E0| after so many periods, root mean square over starts, for these numbers of periods.
std::vector<double> drifts(const std::vector<double>& periods, int starts, const std::string& project) {
  std::vector<double> result;
  for (const double count : periods) {
    double sum = 0;
    for (int i = 0; i < starts; ++i) {
      const Run run = swing(count, "taylor", 1e-15, 0.3 + 0.05 * i, project);
      const double drift =
          run.summary["energy"]["final"].get<double>() - run.summary["energy"]["initial"].get<double>();
      sum += drift * drift;
    }
    result.push_back(std::sqrt(sum / starts));
  }
  return result;
}

/// The slope of log(drift) over log(periods), by least squares.
double exponent(const std::vector<double>& periods, const std::vector<double>& drift) {
  const auto n = static_cast<double>(periods.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < periods.size(); ++i) {
    const double x = std::log(periods[i]), y = std::log(drift[i]);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

TEST_CASE("long runs: phase and energy of a pendulum after a thousand periods") { check_phase(1e3); }
TEST_CASE("long runs: phase and energy of a pendulum after a million periods", "[full]") { check_phase(1e6); }

// Rounding that favours no side makes a random walk of the energy: exponent 1/2. A bias, however small, makes it 1 in
// the end. Means over 32 starts scatter by 1/8 in each point, 0.02 in a slope over three decades.
TEST_CASE("long runs: the energy does a random walk", "[full]") {
  const std::vector<double> periods = {1e2, 1e3, 1e4, 1e5};
  for (const std::string project : {"on", "off"}) {
    const std::vector<double> drift = drifts(periods, 32, project);
    CAPTURE(project, drift);
    CHECK(exponent(periods, drift) < 0.6);
  }
}

TEST_CASE("long runs: constraints keep to rounding for 1e5 periods", "[full]") {
  for (const std::string& method : adaptive_methods) {
    const Run run = swing(1e5, method, 1e-9);
    CHECK(run.constraint_error("rod", "position") < 1e-13);
    CHECK(run.constraint_error("rod", "velocity") < 1e-13);
    // A chain of two rods, for as many of its own periods of about 2 s.
    const Run chain = completed(example_model("double_pendulum"), method, 1e-9, {"--to", "2e5", "--every", "2e5"});
    for (const std::string rod : {"upper_rod", "lower_rod"}) {
      CHECK(chain.constraint_error(rod, "position") < 1e-13);
      CHECK(chain.constraint_error(rod, "velocity") < 1e-13 * 10);  // of speeds up to 10
    }
  }
}

}  // namespace mbcc::test
