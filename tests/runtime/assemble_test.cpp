// Starts that are moved onto the constraints.

#include <catch2/catch.hpp>
#include <cmath>

#include "sample_run.hpp"

using namespace mbrt::test;

namespace {

/// Newton's method ends within a few roundings of numbers of size 1.
constexpr double rounding = 1e-14;

}  // namespace

TEST_CASE("an inconsistent start is refused unless it is to be assembled") {
  const SampleRun run = run_sample("loose");
  CHECK(run.exit_code == 3);
  CHECK(run.errors ==
        "loose.mbd:4: error: the start violates constraint `ellipse`: its value is 1, 0.447 away from zero in the "
        "coordinates\n"
        "loose.mbd:5: error: the start violates constraint `again`: its value is 2, 0.447 away from zero in the "
        "coordinates\n"
        "loose.mbd:6: error: the initial velocities violate constraint `pace`: its value is -1.75, 0.583 away from "
        "zero in the speeds\n");
}

TEST_CASE("assembling finds the nearest consistent start") {
  const SampleRun run = run_sample("loose", {"--assemble"});
  CHECK(run.errors.empty());
  REQUIRE(run.exit_code == 0);
  CHECK(run.largest("ellipse", "position") < rounding);
  CHECK(run.largest("ellipse", "velocity") < rounding);
  CHECK(run.largest("pace", "velocity") < rounding);
  // The way from the start is normal to the ellipse: one Newton step after another alone would end 0.02 off.
  const double x = run.final_value("x1"), y = run.final_value("y1");
  CHECK((x - 2) * 2 * y == Approx((y - 1) * x / 2).margin(rounding));
  CHECK(x * x / 4 + y * y == Approx(1).margin(rounding));
  // Velocities lose their part along the normal (x/2, 2y), no more, and the nearest speed of 2 keeps its direction.
  CHECK((run.final_value("vx1") - 0.5) * 2 * y == Approx((run.final_value("vy1") - 0.25) * x / 2).margin(rounding));
  CHECK(run.final_value("vx2") == Approx(1.2).margin(rounding));
  CHECK(run.final_value("vy2") == Approx(1.6).margin(rounding));
  CHECK(run.final_value("x2") == 0);  // no constraint, no motion
}

TEST_CASE("what is fixed or given on the line stays") {
  const SampleRun fixed = run_sample("loose", {"--assemble", "--fix", "y1", "--fix", "vx2", "--initial", "y1=0.6"});
  REQUIRE(fixed.exit_code == 0);
  CHECK(fixed.final_value("y1") == 0.6);
  CHECK(fixed.final_value("x1") == Approx(1.6).margin(rounding));
  CHECK(fixed.final_value("vx2") == 0.9);
  CHECK(fixed.final_value("vy2") == Approx(std::sqrt(4 - 0.81)).margin(rounding));
}

TEST_CASE("a start that cannot be assembled is refused with what is left") {
  const SampleRun run = run_sample("loose", {"--assemble", "--initial", "x1=3", "--initial", "y1=1.5"});
  CHECK(run.exit_code == 3);
  CHECK(run.errors ==
        "loose.mbd:4: error: the start violates constraint `ellipse`: its value is 3.5, 1.04 away from zero in the "
        "coordinates\n"
        "loose.mbd:5: error: the start violates constraint `again`: its value is 7, 1.04 away from zero in the "
        "coordinates\n");
}
