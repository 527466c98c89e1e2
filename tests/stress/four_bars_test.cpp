// N four-bars in a row, which share the bars between them. Where all bars lie flat the rank drops by N, and each of the
// N loops could go on as a parallelogram or fold; the motion that has gone there goes on.
//
// All standing bars turn by one angle phi from the upright, phi'' = W sin(phi) with W = g((N+1)/2 + N)/((N+1)/3 + N):
// the moment of the weights of N+1 standing bars (at 1/2) and N lying ones (at 1) over the moment of inertia of the
// former (1/3) and the latter (1). They pass the flat position twice a turn.

#include "closed_forms.hpp"
#include "runs.hpp"

namespace mbcc::test {
namespace {

constexpr double end_time = 10;
const std::filesystem::path two = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models/iftomm_a02_fourbar2.mbd";

double weight_over_inertia(int n) { return 9.81 * ((n + 1) / 2.0 + n) / ((n + 1) / 3.0 + n); }

/// Error of every joint's position and velocity against the closed form.
double error_of(const Run& run, int n, double start) {
  const Tumble tumble{weight_over_inertia(n), start};
  const auto [sine, cosine] = tumble.direction(end_time);
  const double rate = tumble.rate(cosine);
  double largest = 0;
  for (int i = 0; i <= n; ++i) {
    const std::string joint = "b[" + std::to_string(i) + "].";
    for (const auto& [quantity, exact] :
         std::map<std::string, double>{{"x", i + sine}, {"y", cosine}, {"vx", rate * cosine}, {"vy", -rate * sine}}) {
      largest = std::max(largest, std::abs(run.final_value(joint + quantity) - exact));
    }
  }
  return largest;
}

/// The errors of some hundred steps add up, and near the upright position, which is passed seven times, a perturbation
/// grows by exp(sqrt(W) t): together to no more than this many tolerances. Rounding, too, grows by that factor.
constexpr double growth = 2000;

/// `start` is phi' at phi = 0. Another one changes where in steps the singular positions come to lie.
void check_row(int n, const std::string& method, double tolerance, double start = 1) {
  INFO(n << " four-bars, " << method << " at " << tolerance << " from a rate of " << start);
  const Run run = completed(n == 2 ? two : stress_model("four_bars_" + std::to_string(n)), method, tolerance,
                            {"--to", flag(end_time), "--set", "rate=" + flag(start)});
  const double error = error_of(run, n, start);
  CAPTURE(error);
  CHECK(error < growth * tolerance);
  CHECK(run.summary["steps"] < 1000);  // 550 at 1e-12 away from singular positions: no collapse near them
  for (const auto& [constraint, errors] : run.summary["constraints"].items()) {
    INFO(constraint);
    // Roundings of places up to n + 1, and what one step of Newton's method leaves of a step's error: its square.
    CHECK(errors["position"] < 4 * eps * (n + 1) + std::pow(8 * tolerance, 2));
    CHECK(errors["velocity"] < 32 * eps * (n + 1));  // of speeds up to 7
  }
}

}  // namespace

TEST_CASE("four-bars: one and two pass their singular positions") {
  check_row(2, "dop853", 1e-10);
  check_row(1, "taylor", 1e-10);
  check_row(1, "taylor", 1e-12);
}

// dop853 is promised to pass down to 1e-10 (Note [projected stages]), taylor to 1e-12.
TEST_CASE("four-bars: from sixty starts, at every tolerance", "[full]") {
  for (int i = 0; i < 60; ++i) {
    const double start = 0.7 + 0.0117 * i;
    for (const int n : {1, 2}) {
      for (int exponent = 4; exponent <= 12; ++exponent) {
        const double tolerance = std::pow(10.0, -exponent);
        check_row(n, "taylor", tolerance, start);
        if (exponent <= 10) {
          check_row(n, "dop853", tolerance, start);
        }
      }
    }
  }
}

TEST_CASE("four-bars: forty in a row", "[full]") {
  check_row(40, "dop853", 1e-9);
  check_row(40, "taylor", 1e-9);
}

}  // namespace mbcc::test
