// The chaotic double pendulum, as long as doubles can follow it: against an integration of its two angles in quadruple
// precision.
//
// A perturbation grows by exp(lambda t), lambda being some 1.5/s here: every rounding on the way comes back with that
// factor, and in thirty seconds nothing is left of sixteen digits. How much it has grown by a time t is measured, not
// guessed: by twins of the reference that start 1e-20 beside it. Of n steps, each off by a few eps at random, there may
// then be an error of a few eps sqrt(n) times the largest growth.

#include "extrapolation.hpp"
#include "runs.hpp"
#include "support/quad.hpp"

namespace mbcc::test {
namespace {

using Angles = std::vector<Quad>;  // of the rods from the downward vertical, and their rates

/// Two equal masses on rods of length 1, by Lagrange's equations.
Angles rate(const Quad& /*t*/, const Angles& y) {
  const Quad g(9.81);
  const Quad s1 = sin(y[0]), c1 = cos(y[0]), s2 = sin(y[1]), c2 = cos(y[1]);
  const Quad s = s1 * c2 - c1 * s2, c = c1 * c2 + s1 * s2;  // of the difference
  const Quad w1 = y[2] * y[2], w2 = y[3] * y[3];
  const Quad inertia = 2 - c * c;
  return {y[2], y[3], (-2 * g * s1 + g * s2 * c - s * (w2 + w1 * c)) / inertia,
          (2 * g * (s1 * c - s2) + s * (2 * w1 + w2 * c)) / inertia};
}

/// x1, y1, x2, y2
std::vector<Quad> places(const Angles& y) {
  const Quad x = sin(y[0]), z = -cos(y[0]);
  return {x, z, x + sin(y[1]), z - cos(y[1])};
}

double distance(const Angles& a, const Angles& b) {
  const std::vector<Quad> p = places(a), q = places(b);
  double largest = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(p[i] - q[i])));
  }
  return largest;
}

/// A motion and its twins, second by second.
struct Bundle {
  static constexpr double beside = 1e-20;
  static constexpr int steps_per_second = 20;

  std::vector<Angles> motions;
  double growth = 1;  ///< the largest so far

  Bundle() {
    const Quad right = 2 * atan(Quad(1));  // both rods stand out horizontally, at rest
    motions.assign(5, {right, right, Quad(0), Quad(0)});
    for (std::size_t i = 0; i < 4; ++i) {
      motions[i + 1][i] += beside;
    }
  }

  void go_on() {
    const Quad step = Quad(1) / steps_per_second;
    for (int i = 0; i < steps_per_second; ++i) {
      for (Angles& motion : motions) {
        motion = extrapolate<10>(rate, Quad(0), motion, step).state;
      }
      for (std::size_t k = 1; k < motions.size(); ++k) {
        growth = std::max(growth, distance(motions[0], motions[k]) / beside);
      }
    }
  }
};

/// Follows the motion until the bound of its error leaves the pendulum's size behind, `end` at the latest; returns that
/// time.
int follow(const std::string& method, int end) {
  const Run run = completed(example_model("double_pendulum"), method, 1e-15, {"--to", flag(end), "--every", "1"});
  const double steps_per_second = run.summary["steps"].get<double>() / end;
  Bundle bundle;
  for (int t = 1; t <= end; ++t) {
    bundle.go_on();
    const double bound = 8 * eps * std::sqrt(steps_per_second * t) * bundle.growth;
    if (bound > 0.1) {
      return t;
    }
    const std::vector<Quad> exact = places(bundle.motions[0]);
    const std::vector<std::string> names = {"upper.x", "upper.y", "lower.x", "lower.y"};
    for (std::size_t i = 0; i < names.size(); ++i) {
      CAPTURE(method, t, bundle.growth, names[i]);
      CHECK(run.table.at(t, names[i]) == near(static_cast<double>(exact[i]), bound));
    }
  }
  return end;
}

}  // namespace

TEST_CASE("chaos: the double pendulum's first three seconds") { follow("taylor", 3); }

TEST_CASE("chaos: the double pendulum as long as doubles can follow", "[full]") {
  for (const std::string& method : adaptive_methods) {
    CHECK(follow(method, 60) > 10);  // ten seconds cost twelve of the sixteen digits
  }
}

}  // namespace mbcc::test
