// What a run leaves behind: rows and summary.

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>

#include "sample_run.hpp"

using namespace mbrt::test;
namespace fs = std::filesystem;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("each accepted step has its row, and the last one is the final state") {
  const SampleRun run = run_sample("pendulum");
  CHECK(run.csv.substr(0, run.csv.find('\n')) == "t,x1,y1,vx1,vy1,ax1,ay1,angle");
  REQUIRE(run.table.rows() == 201);
  CHECK(run.table["t"][7] == 7 * 0.01);
  for (const char* const name : {"t", "x1", "y1", "vx1", "vy1"}) {
    CHECK(run.table.last(name) == run.final_value(name));  // 17 digits lose nothing
  }
  CHECK(run.table.last("angle") == std::atan2(run.table.last("y1"), run.table.last("x1")));
  CHECK(run.table["ay1"][0] == -9.81);
}

TEST_CASE("rows between steps are the motion's") {
  const SampleRun run = run_sample("throw", {"--to", "1", "--step", "0.3", "--every", "0.25"});
  REQUIRE(run.table.rows() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    const double t = 0.25 * static_cast<double>(i);
    CHECK(run.table["t"][i] == t);
    // y = 3 t - t^2 is a polynomial: only rounding, of values up to 3, remains.
    CHECK(run.table["y1"][i] == Approx(3 * t - t * t).margin(20 * eps));
    CHECK(run.table["vy1"][i] == Approx(3 - 2 * t).margin(20 * eps));
    CHECK(run.table["ay1"][i] == -2);
  }
}

TEST_CASE("the interpolant has the order of the method") {
  const auto error = [](const std::string& step) {
    const SampleRun coarse = run_sample("pendulum", {"--to", "1", "--step", step, "--every", "0.0375"});
    const SampleRun fine = run_sample("pendulum", {"--to", "1", "--step", "0.00125", "--every", "0.0375"});
    double largest = 0;
    REQUIRE(coarse.table.rows() == fine.table.rows());
    for (std::size_t i = 0; i < fine.table.rows(); ++i) {
      largest = std::max(largest, std::abs(coarse.table["angle"][i] - fine.table["angle"][i]));
    }
    return largest;
  };
  // Halving the step divides errors of order four by 16; rows fall differently between the steps.
  const double ratio = error("0.02") / error("0.01");
  CHECK(ratio > 10);
  CHECK(ratio < 22);
}

TEST_CASE("the last state has a row even off the grid of rows") {
  const SampleRun run = run_sample("throw", {"--to", "1", "--step", "0.1", "--every", "0.4"});
  CHECK(run.table["t"] == std::vector<double>{0, 0.4, 0.8, 1});
  CHECK(run.table.last("y1") == run.final_value("y1"));
}

TEST_CASE("a run of no length has one row") {
  const SampleRun run = run_sample("pendulum", {"--from", "1", "--to", "1"});
  CHECK(run.exit_code == 0);
  REQUIRE(run.table.rows() == 1);
  CHECK(run.table["t"][0] == 1);
  CHECK(run.summary["steps"] == 0);
  CHECK(run.summary["evaluations"] == 1);
}

TEST_CASE("recording does not change the summary") {
  SampleRun plain = run_sample("paper");
  SampleRun dense = run_sample("paper", {"--every", "0.0009"});
  plain.summary.erase("wall_seconds");
  dense.summary.erase("wall_seconds");
  CHECK(plain.summary == dense.summary);
}

TEST_CASE("the summary has the fields of the contract") {
  const SampleRun run = run_sample("pendulum");
  CHECK(run.summary["model"] == "pendulum");
  CHECK(run.summary["mbcc_version"] == "0.1.0");
  CHECK(run.summary["status"] == "ok");
  CHECK_FALSE(run.summary.contains("message"));
  CHECK(run.summary["method"] == "rk4");
  CHECK(run.summary["steps"] == 200);
  CHECK(run.summary["evaluations"] == 801);
  CHECK(run.summary["monitored"] == true);
  CHECK(run.summary["wall_seconds"].get<double>() > 0);
  CHECK(run.summary["energy"]["initial"] == 0);
  CHECK(run.summary["energy"]["max_drift"].get<double>() >= std::abs(run.summary["energy"]["final"].get<double>()));
  CHECK(run.summary["rank"]["minimum"] == 1);
  CHECK(run.summary["rank"]["events"].empty());
  CHECK(run.summary["solver"]["island_1"] == nlohmann::json({{"ldlt", 801}, {"refined", 0}, {"pinv", 0}}));
}

TEST_CASE("what does not apply is absent from the summary") {
  const SampleRun free = run_sample("throw", {"--to", "1", "--step", "0.1"});
  CHECK_FALSE(free.summary.contains("constraints"));
  CHECK_FALSE(free.summary.contains("rank"));
  CHECK_FALSE(free.summary.contains("solver"));
  const SampleRun paper = run_sample("paper");
  CHECK_FALSE(paper.summary.contains("energy"));
  CHECK_FALSE(paper.summary["constraints"]["constraint_3"].contains("position"));
}

TEST_CASE("the pendulum converges with order four and knows its largest errors") {
  const auto run = [](const std::string& step) { return run_sample("pendulum", {"--to", "1", "--step", step}); };
  const SampleRun reference = run("0.00125");
  const auto error = [&](const SampleRun& other) {
    return std::abs(other.final_value("x1") - reference.final_value("x1"));
  };
  const SampleRun coarse = run("0.02"), fine = run("0.01");
  // 16, changed by the step times a constant of the motion, of the order of ten.
  CHECK(error(coarse) / error(fine) == Approx(16).epsilon(0.15));
  double largest = 0;
  for (std::size_t i = 0; i < fine.table.rows(); ++i) {
    const double x = fine.table["x1"][i], y = fine.table["y1"][i];
    largest = std::max(largest, std::abs(x * x + y * y - 1));
  }
  CHECK(fine.largest("rod", "position") == Approx(largest).epsilon(0).margin(4 * eps));
}

TEST_CASE("the paper's example: published errors, an exact line, a rank lost and found") {
  const SampleRun run = run_sample("paper");
  CHECK(run.exit_code == 0);
  // All digits that are known of them.
  CHECK(run.largest("sphere", "position") == Approx(1.465189e-5).epsilon(0).margin(5e-12));
  CHECK(run.largest("meridian", "position") == Approx(5.484222e-7).epsilon(0).margin(5e-14));
  CHECK(run.largest("constraint_3", "velocity") == 0);
  CHECK(run.largest("constraint_4", "velocity") == 0);
  CHECK(run.final_value("x2") == 2);
  CHECK(run.final_value("y2") == 1);
  const auto& events = run.summary["rank"]["events"];
  REQUIRE(events.size() == 2);
  CHECK(events[0]["time"] == 3.0);
  CHECK(events[0]["rank"] == 1);
  CHECK(events[0]["of"] == 2);
  CHECK(events[0]["constraints"] == nlohmann::json({"constraint_3", "constraint_4"}));
  CHECK(events[1]["rank"] == 2);
  CHECK(run.summary["rank"]["minimum"] == 3);
  CHECK(run.summary["solver"]["island_2"]["pinv"].get<long>() > 0);
  CHECK(run.summary["solver"]["island_1"]["pinv"] == 0);
}

TEST_CASE("a row that vanishes on the way is an event, and no more") {
  const SampleRun run = run_sample("vanishing");
  CHECK(run.exit_code == 0);
  const auto& events = run.summary["rank"]["events"];
  REQUIRE(events.size() == 2);
  CHECK(events[0] == nlohmann::json({{"time", 1.0}, {"rank", 0}, {"of", 1}, {"constraints", {"slider"}}}));
  CHECK(events[1]["time"] == 1.125);
}

TEST_CASE("a row that vanishes at the start counts as soon as it is there") {
  const SampleRun run = run_sample("opening");
  CHECK(run.exit_code == 0);
  // Left alone, y would end at 1/6; it is free in the first step only, where the pull is below the step of 0.01.
  CHECK(std::abs(run.final_value("y1")) < 0.01 * 0.01);
}

TEST_CASE("redundant rows that have drifted are no contradiction") {
  for (const char* const step : {"0.01", "0.05", "0.1"}) {
    const SampleRun run = run_sample("redundant", {"--step", step});
    CHECK(run.exit_code == 0);
    CHECK(run.errors.empty());
    REQUIRE(run.summary["rank"]["events"].size() == 1);
    CHECK(run.summary["rank"]["minimum"] == 1);
  }
}

TEST_CASE("the flag --repeat times unobserved runs and leaves the rest as the first run found it") {
  const SampleRun once = run_sample("paper");
  const SampleRun repeated = run_sample("paper", {"--repeat", "3"});
  CHECK(repeated.summary["monitored"] == false);
  CHECK(repeated.summary["wall_seconds"].get<double>() > 0);
  CHECK(repeated.summary["solver"] == once.summary["solver"]);
  CHECK(repeated.summary["final"] == once.summary["final"]);
  CHECK(repeated.csv == once.csv);
}

TEST_CASE("parameters and starts of the command line are used") {
  // Twice the length, and twice the gravity: the same angles.
  const SampleRun one = run_sample("pendulum", {"--to", "1"});
  const SampleRun two =
      run_sample("pendulum", {"--to", "1", "--set", "length=2", "gravity=19.62", "--initial", "x1=2"});
  CHECK(two.exit_code == 0);
  CHECK(two.final_value("x1") == Approx(2 * one.final_value("x1")).epsilon(1e-12));  // rounding over 100 steps
}

TEST_CASE("results take the place of older ones, and nothing else is left in the directory") {
  const mbcc::test::ScratchDirectory scratch;
  mbcc::test::write_file(scratch / "old.csv", "old");
  fs::create_symlink("old.csv", scratch / "link.csv");
  CHECK(run_plain("pendulum", {"--to", "0", "--csv", scratch / "link.csv"}).exit_code == 0);
  CHECK(fs::is_symlink(scratch / "link.csv"));
  CHECK(mbcc::test::read_file(scratch / "old.csv").substr(0, 2) == "t,");
  CHECK(std::distance(fs::directory_iterator((scratch / "old.csv").parent_path()), fs::directory_iterator()) == 2);
}

TEST_CASE("a full disk is said, with exit code 2") {
  const auto outcome = run_plain("pendulum", {"--csv", "/dev/full"});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors == "error: cannot write `/dev/full`: No space left on device\n");
  CHECK(fs::is_character_file("/dev/full"));
}
