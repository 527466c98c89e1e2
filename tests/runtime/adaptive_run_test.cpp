// Runs of methods that choose their steps, and what keeps motions on their constraints, as users see them.

#include <catch2/catch.hpp>
#include <cmath>

#include "sample_run.hpp"

using namespace mbrt::test;

namespace {

/// The value of the pendulum's constraint in one row.
double error_of_rod(const SampleRun& run, std::size_t row) {
  const double x = run.table["x1"][row], y = run.table["y1"][row];
  return x * x + y * y - 1;
}

}  // namespace

TEST_CASE("the summary tells how the steps were chosen") {
  const SampleRun run = run_sample("pendulum", {"--method", "dop853", "--tolerance", "1e-8"});
  CHECK(run.exit_code == 0);
  CHECK(run.summary["method"] == "dop853");
  CHECK(run.summary["tolerance"] == 1e-8);
  CHECK(run.summary["projections"] == run.summary["steps"]);
  const long steps = run.summary["steps"], rejected = run.summary["rejected"];
  CHECK(run.summary["evaluations"] == 2 + 12 * steps + 11 * rejected);
  CHECK(run.largest("rod", "position") < 1e-14);
  CHECK(run.largest("rod", "velocity") < 1e-14);
}

TEST_CASE("rows between steps come from the interpolant of the method") {
  const SampleRun run = run_sample("pendulum", {"--method", "dop853", "--every", "0.013"});
  CHECK(run.table.rows() == 155);  // 154 within the 2 s, and the end
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    // Order 7 where steps have order 8: some hundred tolerances. A cubic over steps of 0.06 would be off by 1e-4.
    CHECK(std::abs(error_of_rod(run, row)) < 300 * 1e-9);
  }
}

TEST_CASE("every method projects, or does not") {
  for (const char* const method : {"rk4", "dop853"}) {
    const SampleRun on = run_sample("pendulum", {"--method", method, "--project", "on"});
    const SampleRun off = run_sample("pendulum", {"--method", method, "--project", "off"});
    CHECK(on.largest("rod", "position") < 1e-14);
    CHECK(off.largest("rod", "position") > 1e-10);
    CHECK_FALSE(off.summary.contains("projections"));
  }
}

TEST_CASE("stabilized errors decay as Baumgarte's equation says, with every method") {
  for (const char* const method : {"rk4", "dop853"}) {
    const SampleRun run =
        run_sample("pendulum", {"--method", method, "--step", "0.001", "--tolerance", "1e-12", "--project", "off",
                                "--stabilize", "1,1,1", "--initial", "x1=1.0000001"});
    REQUIRE(run.exit_code == 0);
    // h'' + 2 h' + h = 0 from h = 2e-7 at rest; rk4 itself is off by 3e-10 at this step.
    CHECK(error_of_rod(run, run.table.rows() - 1) == Approx(2e-7 * 3 * std::exp(-2)).margin(1e-9));
  }
  const SampleRun loose = run_sample(
      "loose", {"--method", "dop853", "--assemble", "--to", "1", "--stabilize", "1,1,2", "--project", "off"});
  CHECK(loose.exit_code == 0);
}

TEST_CASE("a force that is no number ends adaptive steps at the edge itself") {
  const SampleRun run = run_sample("edge", {"--method", "dop853"});
  CHECK(run.exit_code == 3);
  CHECK(run.errors == "scene.mbd:4: error: force on particle 1, y is not a finite number at t = 1\n");
  CHECK(run.final_value("t") == Approx(1).epsilon(1e-14));  // steps shrink to the last that the time resolves
}

TEST_CASE("where no step is short enough the motion that changes too fast is named") {
  const SampleRun run = run_sample("pole");
  CHECK(run.exit_code == 3);
  CHECK(run.errors.find("error: at t = 1 no step is short enough for `vy1` to stay within the tolerance 1e-09\n") == 0);
  CHECK(run.summary["status"] == "failed");
}

TEST_CASE("contradictory constraints stop an adaptive run, too") {
  const SampleRun run = run_sample("contradiction", {"--method", "dop853"});
  CHECK(run.exit_code == 3);
  CHECK(run.errors.find("contradiction.mbd:4: error: no acceleration satisfies these constraints together at t = ") ==
        0);
}

TEST_CASE("changes of rank are events of adaptive runs") {
  const SampleRun run = run_sample("opening", {"--method", "dop853", "--to", "1"});
  CHECK(run.exit_code == 0);
  const auto& events = run.summary["rank"]["events"];
  REQUIRE(events.size() == 2);  // the row vanishes at the start, and is there at the next accepted state
  CHECK(events[0]["rank"] == 0);
  CHECK(events[1]["rank"] == 1);
  CHECK(events[1]["constraints"] == nlohmann::json::array({"axis"}));
}
