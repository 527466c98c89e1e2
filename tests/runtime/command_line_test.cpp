// The command line of an emitted program: what it takes, and what it says to mistakes.

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "sample_run.hpp"

using namespace mbrt::test;
using mbcc::test::Outcome;

namespace {

using Arguments = std::vector<std::string>;

}  // namespace

TEST_CASE("mistakes on the command line end with exit code 2 and one line") {
  const std::vector<std::pair<Arguments, std::string>> mistakes = {
      {{"--set", "gravty=1"}, "the model has no parameter `gravty`, did you mean `gravity`"},
      {{"--set", "mass=1"}, "the model has no parameter `mass`"},
      {{"--initial", "vz1=1"}, "the model has no coordinate or speed `vz1`, did you mean `vx1`"},
      {{"--set", "gravity"}, "`--set gravity` is not of the form NAME=VALUE"},
      {{"--set", "gravity=1.5g"}, "`1.5g` in `--set gravity=1.5g` is not a finite number"},
      {{"--set", "gravity=inf"}, "`inf` in `--set gravity=inf` is not a finite number"},
      {{"--set", "gravity=1", "--set", "gravity=1"}, "`--set` gives `gravity` two values"},
      {{"--step", "0"}, "the step 0 is not positive"},
      {{"--step", "-0.1"}, "the step -0.1 is not positive"},
      {{"--step", "1e-300"}, "the step 1e-300 is too small: 2e+300 steps"},
      {{"--step", "0.1", "--step", "0.1"}, "`--step` is given more than once"},
      {{"--step"}, "`--step` needs a value"},
      {{"--to", "-1"}, "the end time -1 is before the start time 0"},
      {{"--from", "nan"}, "`nan` in `--from` is not a finite number"},
      {{"--every", "0"}, "`--every 0` is not positive"},
      {{"--cutoff", "0.01"}, "the cut-off 0.01 is above 0.001"},
      {{"--repeat", "1.5"}, "`1.5` in `--repeat` is not a number of times"},
      {{"--frm", "1"}, "there is no flag `--frm`, did you mean `--from`"},
      {{"result.csv"}, "there is no flag `result.csv`"},
      {{"--csv", "same", "--summary", "same"}, "`--csv` and `--summary` both write to `same`"},
      {{"--npy", "same", "--summary", "same"}, "`--npy` and `--summary` both write to `same`"},
      {{"--npy", "-"}, "`--npy` needs a file: the number of rows stands at its beginning and is known at the end"},
      {{"--residuals"}, "`--residuals` adds to what is recorded: it needs `--csv` or `--npy`"},
      {{"--csv", "/nowhere/a.csv"}, "cannot write `/nowhere/a.csv`: No such file or directory"},
      {{"--method", "rk5"},
       "the method `rk5` is not part of this version of mbcc, which has `rk4`, `dop853`, `taylor`, `radau` and `auto`"},
      {{"--method", "radau"},
       "this program has no derivatives of its rates: compile the model with `--method radau`, or let its `integrate` "
       "name the method"},
      {{"--method", "taylor"},
       "this program has no Taylor series: compile the model with `--method taylor`, or let its `integrate` name the "
       "method"},
      {{"--method", "dop853", "--tolerance", "1e-16"}, "the tolerance 1e-16 is below 2.2e-16, the rounding of numbers"},
      {{"--fix", "x1"}, "`--fix` holds what `--assemble` would move: it needs `--assemble`"},
      {{"--assemble", "--fix", "x3"}, "the model has no coordinate or speed `x3`, did you mean `x1`"},
      {{"--stabilize", "1,2"}, "`--stabilize 1,2` is not of the form B1,B2,B3"},
      {{"--stabilize", "1,2,x"}, "`x` in `--stabilize` is not a finite number"},
      {{"--stabilize", "1,2,0"}, "`--stabilize 0` is not positive"},
      {{"--project", "yes"}, "`--project yes` is neither `on` nor `off`"},
  };
  for (const auto& [arguments, message] : mistakes) {
    const Outcome outcome = run_plain("pendulum", arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.errors == "error: " + message + "\n");
    CHECK(outcome.output.empty());
  }
}

TEST_CASE("a model without times needs them on the line") {
  CHECK(run_plain("throw", {"--step", "0.1"}).errors == "error: neither the model nor `--to` says when to stop\n");
  CHECK(run_plain("throw", {"--to", "1", "--method", "rk4"}).errors ==
        "error: neither the model nor `--step` gives the step of `rk4`\n");
  CHECK(run_plain("throw", {"--to", "1", "--step", "0.1"}).exit_code == 0);
}

TEST_CASE("a step without a method means rk4, and neither means auto at 1e-9") {
  CHECK(run_sample("throw", {"--to", "1", "--step", "0.1"}).summary["method"] == "rk4");
  const SampleRun chosen = run_sample("throw", {"--to", "1"});
  CHECK(chosen.summary["method"] == "dop853");
  CHECK(chosen.summary["tolerance"] == 1e-9);
  CHECK(run_plain("throw", {"--to", "1"}).output.find("throw: ok, dop853 by auto, ") == 0);
  CHECK(run_sample("edge", {"--to", "0.5", "--method", "auto"}).summary["method"] == "dop853");  // its model has a step
}

TEST_CASE("help is no mistake and knows the model's defaults") {
  const Outcome outcome = run_plain("pendulum", {"--help"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors.empty());
  CHECK(outcome.output.find("step of rk4 [0.01]") != std::string::npos);
}

TEST_CASE("flags that change nothing are accepted") {
  CHECK(run_plain("pendulum", {"--project", "off", "--method", "rk4"}).errors.empty());
  CHECK(run_plain("pendulum", {"--tolerance", "1e-9"}).errors ==
        "warning: `--tolerance` has no effect on `rk4`, whose step is constant\n");
  CHECK(run_plain("pendulum", {"--method", "dop853", "--step", "1"}).errors ==
        "warning: `--step` has no effect on `dop853`, which chooses its steps\n");
}

TEST_CASE("a step that does not divide the span is a warning") {
  const SampleRun run = run_sample("pendulum", {"--to", "1", "--step", "0.3"});
  CHECK(run.exit_code == 0);
  CHECK(run.errors == "warning: the step 0.3 does not divide the span from 0 to 1: the last step is shortened\n");
  CHECK(run.summary["steps"] == 4);
  CHECK(run.final_value("t") == 1);
}

TEST_CASE("without --quiet people read a summary, unless results go to the same place") {
  const Outcome plain = run_plain("pendulum", {});
  CHECK(plain.output.find("pendulum: ok, rk4, 200 steps of 0.01 from t = 0 to 2 in ") == 0);
  CHECK(plain.output.find("  rod ") != std::string::npos);
  CHECK(plain.output.find("  energy 0, largest drift ") != std::string::npos);
  CHECK(run_plain("pendulum", {"--quiet"}).output.empty());
  CHECK(run_plain("pendulum", {"--csv", "-", "--to", "0"}).output ==
        "t,x1,y1,vx1,vy1,ax1,ay1,angle\n0,1,0,0,0,0,-9.8100000000000005,0\n");
  CHECK(nlohmann::json::parse(run_plain("pendulum", {"--summary", "-"}).output)["status"] == "ok");
}
