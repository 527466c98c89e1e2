// The method `taylor` as its user runs it: accuracy, switches, changes of rank.

#include <catch2/catch.hpp>
#include <cmath>

#include "support/accuracy.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {
namespace {

const std::filesystem::path paper = std::filesystem::path(MBCC_SOURCE_DIR) / "examples/artigo5/artigo5.mbd";

Run run_with_series(const std::filesystem::path& model, std::vector<std::string> flags) {
  flags.insert(flags.end(), {"--method", "taylor"});
  Run run = run_model(model, flags);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(run.summary["method"] == "taylor");
  return run;
}

/// A particle on a line with this force, from x1 = 1 at rest.
Run run_line(const std::string& force, double to) {
  const ScratchDirectory scratch;
  write_file(scratch / "line.mbd", "dimension 1\nparticle 1 { mass = 1; position = 1; force = " + force + " }\n");
  return run_with_series(scratch / "line.mbd", {"--to", flag(to), "--tolerance", "1e-12"});
}

}  // namespace

TEST_CASE("errors follow the tolerance on the paper's example, which passes t = 3") {
  constexpr double z1 = 0.07287998710974598;  // (sqrt2/2) cn(u)/dn(u) at u = 10 pi, parameter 1/2
  for (const double tolerance : {1e-4, 1e-7, 1e-10, 1e-13}) {
    const Run run = run_with_series(paper, {"--tolerance", flag(tolerance)});
    INFO("tolerance " << tolerance);
    // A hundred steps and more add up, and a perturbation of the motion grows tenfold in the five turns.
    CHECK(run.final_value("z1") == near(z1, 1e3 * tolerance));
    CHECK(run.final_value("z2") == near(0.5, 1e-13));  // moves uniformly
    CHECK(run.summary["steps"] < 300);
  }
}

TEST_CASE("a start at a change of rank is left to dop853, and counted") {
  // At t = 3 the guide has turned three times: particle 1 may start where it does at t = 0.
  const Run run = run_with_series(paper, {"--from", "3", "--to", "4", "--initial", "z2=0", "--tolerance", "1e-12"});
  CHECK(run.summary["fallbacks"] >= 1);
  CHECK(run.summary["fallbacks"] < run.summary["steps"]);
  CHECK(run.summary["rank"]["minimum"] < 4);
  CHECK(run.final_value("z2") == near(0.25, 1e-13));
  CHECK(run.final_value("x2") == 2);
  CHECK(run.output.find("left to `dop853`, where there is no series\n") != std::string::npos);
}

TEST_CASE("steps end at switches") {
  // Between the switches the motion is a parabola, a polynomial of degree two, so that all errors are those of the
  // switching times: within a hundredth of the tolerance of a step.
  const double half = 2 * std::sqrt(2.0);  // from 1 with acceleration -1 to 0, and on to -1 with +1
  CHECK(run_line("-sign(x1)", half).final_value("x1") == near(-1, 1e-11));
  CHECK(run_line("-sign(x1)", 10 * half).final_value("x1") == near(1, 1e-10));
  CHECK(run_line("if(t <= 1, -1, 1)", 2).final_value("x1") == near(0, 1e-11));
  // max(x1, 0) turns the spring off for x1 < 0: a quarter of a swing, then speed -1.
  CHECK(run_line("-max(x1, 0)", std::acos(0.0) + 1).final_value("x1") == near(-1, 1e-11));
}

TEST_CASE("equations that a run changes have no emitted series") {
  const Run run = run_model(paper, {"--method", "taylor", "--stabilize", "1,1,1"});
  CHECK(run.exit_code == 2);
  CHECK(run.errors == "error: `--stabilize` changes the equations, whose series `taylor` has: use `dop853`\n");
}

TEST_CASE("rows between steps come from the series") {
  const ScratchDirectory scratch;
  // A spring that is pulled as cos t would have it: looking at other times must not disturb the integration.
  write_file(scratch / "spring.mbd", "dimension 1\nparticle 1 { mass = 1; position = 1; force = -2*x1 + cos(t) }\n");
  const Run run = run_with_series(scratch / "spring.mbd", {"--to", "5", "--every", "0.01", "--tolerance", "1e-13"});
  REQUIRE(run.table.rows() == 501);
  CHECK(run.summary["steps"] < 20);
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    CHECK(run.table["x1"][row] == near(std::cos(run.table["t"][row]), 1e-12));  // ten steps at 1e-13
  }
}

}  // namespace mbcc::test
