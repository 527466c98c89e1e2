// The method `radau` as its user runs it: stiff scenes, emitted and interpreted, and what changes its equations.

#include <catch2/catch.hpp>
#include <cmath>

#include "models/published_model.hpp"
#include "support/variable.hpp"

namespace mbcc::test {
namespace {

/// A mass between a spring of stiffness s and a damper of s + 1: x'' + (s + 1) x' + s x = 0, whose solutions are e^-t
/// and e^(-s t). From (1, -1) it is the slow one alone.
std::string creeping_mass(double stiffness) {
  return "dimension 1\nparameter s = " + flag(stiffness) +
         "\nparticle 1 { mass = 1; position = 1; velocity = -1; force = -(s + 1)*vx1 - s*x1 }\n";
}

Run run_stiff(const std::string& text, std::vector<std::string> flags) {
  const ScratchDirectory scratch;
  write_file(scratch / "scene.mbd", text);
  flags.insert(flags.end(), {"--method", "radau"});
  Run run = run_model(scratch / "scene.mbd", flags);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(run.summary["method"] == "radau");
  return run;
}

}  // namespace

TEST_CASE("a stiff linear scene takes steps after its slow motion, at every stiffness") {
  for (const double stiffness : {1e2, 1e5, 1e8}) {
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const Run run = run_stiff(creeping_mass(stiffness), {"--to", "5", "--tolerance", flag(tolerance)});
      INFO(stiffness << " at " << tolerance);
      CHECK(run.final_value("x1") == near(std::exp(-5), 10 * tolerance));
      CHECK(run.summary["steps"] < 120);
      CHECK(run.summary["jacobians"] < 5);
      CHECK(run.summary["differenced"] == 0);
    }
  }
}

TEST_CASE("a fast motion at the start dies out, and rows between steps follow the slow one") {
  // From (1, 0): x = (s e^-t - e^(-s t)) / (s - 1).
  constexpr double s = 1e4;
  const Run run = run_stiff("dimension 1\nparticle 1 { mass = 1; position = 1; force = -10001*vx1 - 1e4*x1 }\n",
                            {"--to", "2", "--every", "0.05", "--tolerance", "1e-8"});
  for (std::size_t row = 0; row < run.table.rows(); ++row) {
    const double t = run.table["t"][row];
    CHECK(run.table["x1"][row] == near((s * std::exp(-t) - std::exp(-s * t)) / (s - 1), 1e-7));
    CHECK(run.table["vx1"][row] == near(s / (s - 1) * (std::exp(-s * t) - std::exp(-t)), 1e-7));
  }
  CHECK(run.summary["steps"] < 150);
}

TEST_CASE("the stiff flyball governor: errors in proportion to the tolerance, few steps") {
  const PublishedModel model("iftomm_a05_flyball_particles");
  const Run explicit_steps = run_model(models_folder / "iftomm_a05_flyball_particles.mbd",
                                       {"--method", "dop853", "--tolerance", "1e-4", "--to", "0.5"});
  double last = 1;
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    const std::vector<std::string> flags = {"--method", "radau", "--tolerance", flag(tolerance)};
    const Run run = model.run(flags);
    REQUIRE(run.exit_code == 0);
    const double error = model.error(model.end(flags));
    INFO(tolerance << ": error " << error);
    CHECK(error < 100 * tolerance);
    CHECK(error < last / 10);  // of a factor of 100
    // In twenty times the time: stability bounds explicit steps at every tolerance.
    CHECK(run.summary["steps"] < 3 * explicit_steps.summary["steps"].get<long>());
    CHECK(run.summary["differenced"] == 0);
    for (const auto& [constraint, errors] : run.summary["constraints"].items()) {
      CHECK(errors["position"] < 1e-12);
    }
    last = error;
  }
  CHECK(explicit_steps.output.find("`--method radau` takes longer steps\n") != std::string::npos);
}

TEST_CASE("the interpreter runs radau as emitted code does") {
  const std::vector<std::string> flags = {"--to", "1", "--tolerance", "1e-6", "--cxxflags=-O0"};
  const std::string scene = R"(dimension 2
gravity (0, -9.81)
particle 1 { mass = 1; position = (1, 0) }
particle 2 { mass = 0.5; position = (2, 0) }
let reach = (x2 - x1, y2 - y1)
let tension = 1e6*(norm(reach) - 1)*reach
force on 1 = tension
force on 2 = -tension
constraint rod : x1^2 + y1^2 = 1
)";
  const Run emitted = run_stiff(scene, flags);
  const Variable compiler("CXX", "/nonexistent/c++");
  const Run interpreted = run_stiff(scene, flags);
  for (const char* const count : {"steps", "evaluations", "rejected", "jacobians", "factorisations", "projections"}) {
    CHECK(interpreted.summary[count] == emitted.summary[count]);
  }
  CHECK(interpreted.final_value("x2") == near(emitted.final_value("x2"), 1e-9));  // the same steps, other roundings
  CHECK(emitted.output.find(" Jacobians, ") != std::string::npos);
  CHECK(emitted.constraint_error("rod", "position") < 1e-13);
}

TEST_CASE("equations that a run changes have their Jacobian by differences") {
  const Run run = run_stiff(
      "dimension 2\ngravity (0, -9.81)\nparticle 1 { mass = 1; position = (1, 0) }\n"
      "constraint rod : x1^2 + y1^2 = 1\n",
      {"--to", "1", "--stabilize", "1,1,1", "--project", "off"});
  CHECK(run.summary["differenced"] == run.summary["jacobians"]);
  CHECK(run.output.find(" by differences), ") != std::string::npos);
}

TEST_CASE("auto finds out that a scene is stiff, and goes on with radau") {
  const ScratchDirectory scratch;
  write_file(scratch / "scene.mbd", creeping_mass(1e6));
  const auto run = [&](const std::string& method) {
    return run_model(scratch / "scene.mbd", {"--to", "5", "--tolerance", "1e-6", "--method", method});
  };
  const Run chosen = run("auto");
  REQUIRE(chosen.exit_code == 0);
  CHECK(chosen.output.find("` from t = ") != std::string::npos);
  CHECK(chosen.summary["method"] == "dop853");
  CHECK(chosen.summary["stiff_from"] < 1e-2);
  CHECK(chosen.summary["jacobians"] >= 1);
  CHECK(chosen.final_value("x1") == near(std::exp(-5), 1e-5));
  CHECK(chosen.summary["steps"] < 1000);
  // No row is there twice, and none is missing.
  CHECK(chosen.table.rows() == chosen.summary["steps"].get<std::size_t>() + 1);
  for (std::size_t row = 1; row < chosen.table.rows(); ++row) {
    CHECK(chosen.table["t"][row] > chosen.table["t"][row - 1]);
  }
}

}  // namespace mbcc::test
