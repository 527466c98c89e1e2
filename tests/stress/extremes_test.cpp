// Sizes that numbers hardly hold, spans without length, and steps that are too long.

#include "runs.hpp"

namespace mbcc::test {
namespace {

Run swing(const std::string& method, const std::vector<std::string>& sizes) {
  std::vector<std::string> flags = {"--method", method, "--to", "2"};
  if (method == "rk4") {
    flags.insert(flags.end(), {"--step", "0.001"});
  }
  for (const std::string& size : sizes) {
    flags.insert(flags.end(), {"--set", size});
  }
  return run_model(stress_model("units"), flags);
}

void check_same(const Run& run, const Run& reference, double scale) {
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  for (const std::string quantity : {"upper.x", "upper.y", "lower.x", "lower.y", "lower.vx", "lower.vy"}) {
    INFO(quantity);
    // Another solver of the ladder, or other roundings: some 1e3 evaluations of eps each, and perturbations of this
    // motion grow to less than a hundredfold in two seconds. Adaptive steps may differ, too: by their tolerance.
    CHECK(run.final_value(quantity) / scale == near(reference.final_value(quantity), 1e-7));
  }
}

}  // namespace

TEST_CASE("extremes: masses of any size swing alike") {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    INFO(method);
    const Run reference = swing(method, {});
    for (const std::string mass : {"m=1e-300", "m=1e-120", "m=1e120", "m=1e300"}) {
      INFO(mass);
      check_same(swing(method, {mass}), reference, 1);
    }
  }
}

TEST_CASE("extremes: lengths of any size swing alike, as long as their squares are numbers") {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    INFO(method);
    const Run reference = swing(method, {});
    check_same(swing(method, {"length=1e-150", "g=9.81e-150"}), reference, 1e-150);
    check_same(swing(method, {"length=1e150", "g=9.81e150"}), reference, 1e150);
  }
}

TEST_CASE("extremes: what numbers cannot hold is refused, not computed") {
  const Run small = swing("dop853", {"length=1e-200", "g=9.81e-200"});  // its square is 0
  CHECK(small.exit_code == 3);
  CHECK(small.errors ==
        "units.mbd:11: error: the derivatives of constraint `upper_rod` are not finite numbers at t = 0\n");
  const Run light = swing("dop853", {"m=5e-324"});  // whose inverse is infinite
  CHECK(light.exit_code == 3);
  CHECK(light.errors == "error: the acceleration is not a finite number at t = 0\n");
  CHECK(light.table.rows() == 0);
}

TEST_CASE("extremes: a span of no length is one row, the start") {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    std::vector<std::string> flags = {"--method", method, "--from", "1.5", "--to", "1.5"};
    if (method == "rk4") {
      flags.insert(flags.end(), {"--step", "0.001"});
    }
    const Run run = completed(stress_model("units"), flags);
    CHECK(run.summary["steps"] == 0);
    REQUIRE(run.table.rows() == 1);
    CHECK(run.table.last("t") == 1.5);
    CHECK(run.table.last("upper.x") == std::sin(1.0));
    // Released from rest: the lower rod hangs and is carried by the upper one, whose bob feels its own weight alone.
    CHECK(run.table.last("upper.ax") != 0);
  }
}

TEST_CASE("extremes: steps that are too long show in the monitors, or end the run") {
  // One step of 2 s, a period: nobody takes its end for a pendulum's.
  const Run one = completed(stress_model("units"), {"--method", "rk4", "--to", "2", "--step", "1e300"});
  CHECK(one.summary["steps"] == 1);
  CHECK(one.constraint_error("upper_rod", "position") > 1);
  CHECK(one.errors.find("warning: the step 1e+300 does not divide the span from 0 to 2: the last step is shortened") !=
        std::string::npos);
  // Beyond the limit of stability, 2.8 over the frequency of about 3/s, errors grow until numbers end.
  const Run many = run_model(stress_model("units"), {"--method", "rk4", "--to", "1e4", "--step", "2"});
  CHECK(many.exit_code == 3);
  CHECK(many.errors.rfind("error: the motion grows without bound before t = ", 0) == 0);
  CHECK(many.summary["status"] == "failed");
  CHECK(many.table.rows() == many.summary["steps"].get<std::size_t>() + 1);
}

}  // namespace mbcc::test
