// Masses whose ratio is 1e12. Rows of A M^-1/2 then mix entries of that ratio, and what the light side does must come
// out as accurately as what the heavy side does.

#include "closed_forms.hpp"
#include "runs.hpp"

namespace mbcc::test {
namespace {

/// All three pairs at t = 0.4, in which steps of this tolerance lose little more than it.
void check_masses(const std::string& method) {
  const double light = 1e-12, t = 0.4, tolerance = 1e-13, g = 9.81;
  const double accuracy = 100 * tolerance;
  const Run run = completed(stress_model("masses"), method, tolerance, {"--to", flag(t)});
  const auto end = [&](const char* name) { return run.final_value(name); };

  // A dumbbell turns evenly about its centre of mass, which falls. The heavy end circles by 2e-12, to as many digits.
  const double centre = 2 * light / (1 + light), fall = -g * t * t / 2;
  const double c = std::cos(2 * t), s = std::sin(2 * t);
  CHECK(end("light_end.x") == near(centre + 2 * c / (1 + light), accuracy));
  CHECK(end("light_end.y") == near(fall + 2 * s / (1 + light), accuracy));
  CHECK(end("heavy_end.x") == near(centre * (1 - c), accuracy * light));
  CHECK(end("heavy_end.y") == near(fall - centre * s, accuracy));

  // On a heavy cart the bob is a pendulum; the cart moves so that the momentum stays 0. (A cart without freedom would
  // differ by 1e-12 of the rate.)
  const double angle = Swing{1, std::sqrt(g)}.angle(t);
  CHECK(end("light_bob.x") == near(std::sin(angle), accuracy));
  CHECK(end("light_bob.y") == near(-std::cos(angle), accuracy));
  CHECK(end("heavy_cart.x") == near(light * (std::sin(1) - end("light_bob.x")), accuracy * light));

  // A cart without mass exerts no force: the bob falls freely and takes it along. The mass adds a part of 1e-12.
  const double height = 0.8 + fall;
  CHECK(end("heavy_bob.x") == near(0.6, accuracy));
  CHECK(end("heavy_bob.y") == near(height, accuracy));
  CHECK(end("light_cart.x") == near(0.6 - std::sqrt(1 - height * height), accuracy));

  for (const auto& [constraint, errors] : run.summary["constraints"].items()) {
    INFO(constraint);
    CHECK(errors["position"] < 4 * eps);  // roundings of lengths up to 2
  }
}

}  // namespace

TEST_CASE("mass ratios of 1e12, either way") { check_masses("dop853"); }
TEST_CASE("mass ratios of 1e12, either way, with series", "[full]") { check_masses("taylor"); }

}  // namespace mbcc::test
