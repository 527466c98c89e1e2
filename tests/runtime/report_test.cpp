// The report of a run, whole.

#include "report.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "durations.hpp"

namespace mbrt {
namespace {

/// A mechanism of four constraints in two islands.
Description mechanism() {
  static constexpr std::array<ConstraintEntry, 4> constraints = {{{"sphere", "m.mbd:1", true},
                                                                  {"meridian", "m.mbd:2", true},
                                                                  {"constraint_3", "m.mbd:3", false},
                                                                  {"a_name_that_is_rather_long", "m.mbd:4", false}}};
  static constexpr std::array<int, 4> indices = {0, 1, 2, 3};
  static constexpr std::array<IslandEntry, 2> islands = {
      {{std::span(indices).first(2), {}}, {std::span(indices).last(2), {}}}};
  Description model{};
  model.model = "mechanism";
  model.constraints = constraints;
  model.islands = islands;
  return model;
}

Options from_zero_to(double to, double step) {
  Options options;
  options.to = to;
  options.step = step;
  return options;
}

}  // namespace

TEST_CASE("a report tells errors by name, changes of rank, and where the solver had to climb") {
  Description model = mechanism();
  model.has_energy = true;
  Outcome outcome;
  outcome.steps = 1000;
  outcome.evaluations = 4001;
  outcome.wall_seconds = 9.3e-5;
  outcome.time = 5;
  outcome.findings.constraints = {
      {1.465189e-5, 1.5e-4, 2e-15}, {5.484222e-7, 2e-6, 0}, {0, 0, 0}, {0, std::nan(""), 1e300}};
  outcome.findings.initial_energy = -4.905;
  outcome.findings.energy_drift = 1.61e-7;
  outcome.findings.rank_events = {{3, 1, 1}, {3.005, 1, 2}};
  outcome.findings.rank_changes = 2;
  outcome.solves.resize(2);
  outcome.solves[1].refined = 3;
  outcome.solves[1].pinv = 12;
  CHECK(report(model, from_zero_to(5, 0.005), outcome) ==
        "mechanism: ok, rk4, 1000 steps of 0.005 from t = 0 to 5 in 0.093 ms\n"
        "  largest errors of                position      velocity  acceleration\n"
        "  sphere                       1.465189e-05  1.500000e-04  2.000000e-15\n"
        "  meridian                     5.484222e-07  2.000000e-06             0\n"
        "  constraint_3                                          0             0\n"
        "  a_name_that_is_rather_long                          nan 1.000000e+300\n"
        "  rank 1 of 2 from t = 3: `constraint_3`, `a_name_that_is_rather_long`\n"
        "  rank 2 of 2 from t = 3.005: `constraint_3`, `a_name_that_is_rather_long`\n"
        "  4001 solves of `constraint_3`, `a_name_that_is_rather_long`: 3 refined, 12 by the pseudo-inverse\n"
        "  energy -4.905, largest drift 1.61e-07\n");
}

TEST_CASE("a report of a run that did not come to its end says where it is") {
  Description model{};
  model.model = "throw";
  Outcome outcome;
  outcome.status = Status::Interrupted;
  outcome.steps = 1;
  outcome.wall_seconds = 125;
  outcome.time = 0.5;
  outcome.monitored = false;
  CHECK(report(model, from_zero_to(1e9, 0.5), outcome) ==
        "throw: interrupted, rk4, 1 step of 0.5 from t = 0 to 0.5 of 1e+09 in 2 min 5 s unobserved\n");
}

TEST_CASE("a report of a method that chooses its steps tells how well they were chosen") {
  Description model{};
  model.model = "throw";
  Options options;
  options.to = 1;
  options.method = "dop853";
  options.chosen_by_auto = true;
  Outcome outcome;
  outcome.steps = 80;
  outcome.rejected = 3;
  outcome.time = 1;
  CHECK(report(model, options, outcome) ==
        "throw: ok, dop853 by auto, 80 steps (3 more rejected) to tolerance 1e-09 from t = 0 to 1 in 0 ms\n");
}

TEST_CASE("a report tells where a motion became stiff, and what an implicit method took") {
  Description model{};
  model.model = "throw";
  Options options;
  options.to = 1;
  options.method = "dop853";
  Outcome outcome;
  outcome.steps = 80;
  outcome.time = 1;
  outcome.stiff_from = 0.25;
  CHECK(report(model, options, outcome) ==
        "throw: ok, dop853, 80 steps to tolerance 1e-09 from t = 0 to 1 in 0 ms\n"
        "  stiff from t = 0.25 on: `--method radau` takes longer steps\n");
  options.chosen_by_auto = true;
  outcome.jacobians = 3;
  outcome.differenced = 1;
  outcome.factorisations = 1;
  CHECK(report(model, options, outcome) ==
        "throw: ok, dop853 by auto, 80 steps to tolerance 1e-09 from t = 0 to 1 in 0 ms\n"
        "  `radau` from t = 0.25 on, where the motion is stiff\n"
        "  3 Jacobians (1 by differences), 1 factorisation\n");
}

TEST_CASE("a report of many constraints, islands and events shows the worst, and counts the rest") {
  constexpr int many = 20;
  std::array<std::string, many> names;
  std::array<ConstraintEntry, many> constraints{};
  std::array<int, many> indices{};
  std::array<IslandEntry, many> islands{};
  Description model{};
  model.model = "net";
  Outcome outcome;
  outcome.status = Status::Failed;
  outcome.evaluations = 1;
  outcome.findings.rank_changes = 150;
  for (std::size_t i = 0; i < many; ++i) {
    names[i] = "c" + std::to_string(i + 1);
    constraints[i] = {names[i].c_str(), "net.mbd:1", true};
    indices[i] = static_cast<int>(i);
    islands[i] = {std::span(indices).subspan(i, 1), {}};
    outcome.findings.constraints.push_back({static_cast<double>(i % 10), 0, 0});
    outcome.findings.rank_events.push_back({1, i, 0});
    outcome.solves.emplace_back().pinv = 1;
  }
  outcome.findings.constraints[0].position = std::nan("");
  islands[0] = {indices, {}};
  model.constraints = constraints;
  model.islands = islands;
  std::string expected =
      "net: failed, rk4, 0 steps of 1 from t = 0 to 0 of 1 in 0 ms\n"
      "  largest errors of        position      velocity  acceleration\n";
  for (const std::string name : {"c1 ", "c5 ", "c6 ", "c7 ", "c8 ", "c9 ", "c10", "c16", "c17", "c18", "c19", "c20"}) {
    const std::string digit = name == "c1 " ? "nan" : std::to_string((std::stoi(name.substr(1)) - 1) % 10);
    const std::string error = name == "c1 " ? "         nan" : digit + ".000000e+00";
    expected += "  " + name + "                  " + error + "             0             0\n";
  }
  expected += "  and 8 more with smaller errors\n";
  expected += "  rank 0 of 20 from t = 1: `c1`, `c2`, `c3` and 17 more\n";
  for (int i = 2; i <= 10; ++i) {
    expected += "  rank 0 of 1 from t = 1: `c" + std::to_string(i) + "`\n";
  }
  expected += "  and 140 more changes of rank\n";
  expected += "  1 solve of `c1`, `c2`, `c3` and 17 more: 0 refined, 1 by the pseudo-inverse\n";
  for (int i = 2; i <= 10; ++i) {
    expected += "  1 solve of `c" + std::to_string(i) + "`: 0 refined, 1 by the pseudo-inverse\n";
  }
  expected += "  and 10 more islands solved so\n";
  CHECK(report(model, from_zero_to(1, 1), outcome) == expected);
}

TEST_CASE("durations are said in the largest unit that fits") {
  CHECK(duration(0.0005221) == "0.522 ms");
  CHECK(duration(1) == "1 s");
  CHECK(duration(59.94) == "59.9 s");
  CHECK(duration(60) == "1 min 0 s");
  CHECK(duration(3599.9) == "59 min 59 s");
  CHECK(duration(7380) == "2 h 3 min");
}

TEST_CASE("a report tells how many steps a series left to another method") {
  Options options = from_zero_to(5, not_given);
  options.method = "taylor";
  options.tolerance = 1e-12;
  Outcome outcome;
  outcome.steps = 100;
  outcome.fallbacks = 2;
  outcome.wall_seconds = 9.3e-5;
  outcome.time = 5;
  CHECK(report(mechanism(), options, outcome) ==
        "mechanism: ok, taylor, 100 steps to tolerance 1e-12 from t = 0 to 5 in 0.093 ms\n"
        "  2 steps left to `dop853`, where there is no series\n");
}

}  // namespace mbrt
