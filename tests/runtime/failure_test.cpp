// Runs that cannot go on: the cause by its name and place, exit code 3, and what was computed until then.

#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <thread>

#include "sample_run.hpp"

using namespace mbrt::test;
namespace fs = std::filesystem;

extern char** environ;

TEST_CASE("a force that is no number is named, at the stage where it arose") {
  const SampleRun run = run_sample("edge");
  CHECK(run.exit_code == 3);
  const std::string message = "scene.mbd:4: error: force on particle 1, y is not a finite number at t = 1.05";
  CHECK(run.errors ==
        "warning: the step 0.3 does not divide the span from 0 to 2: the last step is shortened\n" + message + "\n");
  CHECK(run.summary["status"] == "failed");
  CHECK(run.summary["message"] == message);
  CHECK(run.summary["steps"] == 3);
  CHECK(run.table.rows() == 4);
  CHECK(run.table.last("t") == run.final_value("t"));
}

TEST_CASE("a start that is no number is named too") {
  const SampleRun run = run_sample("edge", {"--initial", "x1=1.5", "--step", "0.1"});
  CHECK(run.exit_code == 3);
  CHECK(run.summary["message"] == "scene.mbd:4: error: force on particle 1, y is not a finite number at t = 0");
  CHECK(run.table.rows() == 0);
}

TEST_CASE("a constraint without derivatives is named") {
  const SampleRun run = run_sample("cliff");
  CHECK(run.exit_code == 3);
  CHECK(run.errors.find("cliff.mbd:5: error: the derivatives of constraint `cliff` are not finite numbers at t = ") ==
        0);
  CHECK(run.table.rows() > 50);  // it falls off near t = 0.73, x = t + t^2/2 at the fastest
}

TEST_CASE("contradictory constraints stop the run with both names, on any step") {
  for (const char* const step : {"0.001", "0.01", "0.5"}) {
    const SampleRun run = run_sample("contradiction", {"--step", step});
    CHECK(run.exit_code == 3);
    CHECK(run.summary["status"] == "failed");
    const auto message = run.summary["message"].get<std::string>();
    CHECK(message.find("contradiction.mbd:4: error: no acceleration satisfies these constraints together at t = ") ==
          0);
    CHECK(message.find("`slow` (contradiction.mbd:4") != std::string::npos);
    CHECK(message.find("`fast` (contradiction.mbd:5") != std::string::npos);
    CHECK(run.table.rows() == 1);  // the start is the last state that satisfies both
  }
}

TEST_CASE("a start made inconsistent is refused, constraint by constraint") {
  const SampleRun moved = run_sample("pendulum", {"--initial", "x1=1.1"});
  CHECK(moved.exit_code == 3);
  CHECK(moved.errors ==
        "pendulum.mbd:7: error: the start violates constraint `rod`: its value is 0.21, 0.0955 away from zero in the "
        "coordinates\n");
  CHECK(moved.summary["status"] == "failed");
  CHECK(moved.csv == "t,x1,y1,vx1,vy1,ax1,ay1,angle\n");
  CHECK(run_sample("pendulum", {"--set", "length=2"}).exit_code == 3);
  const SampleRun kicked = run_sample("redundant", {"--initial", "vx1=0.1"});
  CHECK(kicked.exit_code == 3);
  CHECK(kicked.errors ==
        "redundant.mbd:4: error: the initial velocities violate constraint `circle`: its rate is 0.2, 0.1 away from "
        "zero in the speeds\n"
        "redundant.mbd:5: error: the initial velocities violate constraint `again`: its rate is 0.4, 0.1 away from "
        "zero in the speeds\n");
  CHECK(run_sample("pendulum", {"--initial", "x1=1.0000001"}).exit_code == 0);  // a start rounded to seven digits
}

TEST_CASE("an interrupted run writes what it has") {
  const mbcc::test::ScratchDirectory scratch;
  const fs::path csv = scratch / "run.csv";
  const std::string summary = scratch / "run.json";
  std::array<std::string, 11> words = {SAMPLES,   "throw", "--to",      "1e9",   "--step", "1e-3",
                                       "--every", "1",     "--summary", summary, "--csv"};
  std::vector<char*> arguments;
  for (std::string& word : words) {
    arguments.push_back(word.data());
  }
  std::string path = csv.string();
  arguments.push_back(path.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  REQUIRE(posix_spawn(&process, SAMPLES, nullptr, nullptr, arguments.data(), environ) == 0);
  while (fs::is_empty(csv.parent_path())) {  // its files are opened after it has begun to listen for signals
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  kill(process, SIGINT);
  int status = 0;
  REQUIRE(waitpid(process, &status, 0) == process);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 130);

  const auto results = nlohmann::json::parse(mbcc::test::read_file(summary));
  CHECK(results["status"] == "interrupted");
  const std::string text = mbcc::test::read_file(csv);
  CHECK(text.back() == '\n');
  const mbcc::test::Table table = mbcc::test::parse_csv(text);
  CHECK(table.last("t") == results["final"]["t"].get<double>());
  CHECK(table.last("ay1") == -2);
}
