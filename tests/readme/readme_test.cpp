// What README.md shows is true: models are accepted, commands print what stands there, emitted code has the excerpt,
// and the control loop compiles and prints its line.
#include <catch2/catch.hpp>

#include "support/markdown.hpp"
#include "support/run_model.hpp"

namespace {

using namespace mbcc::test;

const std::filesystem::path root = MBCC_SOURCE_DIR;
const std::filesystem::path model = root / "examples/planar_pendulum/planar_pendulum.mbd";

/// The n-th block of a language in README.md.
std::string block(const std::string& language, int n) { return block_of(root / "README.md", language, n).text; }

/// All but what depends on the machine: the time of a run, and errors that are rounding alone.
void check_report(const std::vector<std::string>& printed, const std::vector<std::string>& shown) {
  REQUIRE(printed.size() == shown.size());
  REQUIRE(shown.size() == 4);
  const auto without_time = [](const std::string& line) { return line.substr(0, line.rfind(" in ")); };
  CHECK(without_time(printed[0]) == without_time(shown[0]));
  CHECK(printed[1] == shown[1]);
  CHECK(printed[3] == shown[3]);

  struct Errors {
    std::string constraint;
    double position = 0, velocity = 0, acceleration = 0;
  };
  const auto read = [](const std::string& line) {
    Errors errors;
    std::istringstream(line) >> errors.constraint >> errors.position >> errors.velocity >> errors.acceleration;
    return errors;
  };
  const Errors found = read(printed[2]), expected = read(shown[2]);
  CHECK(found.constraint == expected.constraint);
  // Errors of the method; what rounding adds in 5000 steps, some 1e-15, is below 1e-6 of them.
  CHECK(found.position == Approx(expected.position).epsilon(1e-5));
  CHECK(found.velocity == Approx(expected.velocity).epsilon(1e-5));
  CHECK(found.acceleration < 10 * expected.acceleration);  // of rounding, which other flags do otherwise
}

}  // namespace

TEST_CASE("the model in the README is the shipped example") {
  CHECK(read_file(model).find(block("mbd", 0)) != std::string::npos);
}

TEST_CASE("mbcc prints what the README shows") {
  const Outcome outcome = run_mbcc({"run", model.string()});
  REQUIRE(outcome.exit_code == 0);
  check_report(lines_of(outcome.output), lines_of(block("text", 0)));
}

TEST_CASE("mbcc finds the structure that the README shows") {
  const Outcome outcome = run_mbcc({"check", model.string()});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.output.rfind(block("text", 1), 0) == 0);
}

TEST_CASE("mbcc emits the code that the README shows") {
  const Outcome outcome = run_mbcc({model.string(), "-o", "-"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.output.find(block("cpp", 0)) != std::string::npos);
}

TEST_CASE("the README's page on the language is a model without a warning, and runs") {
  const ScratchDirectory scratch;
  const std::string tour = scratch / "tour.mbd";
  write_file(tour, block("mbd", 1));
  const Outcome outcome = run_mbcc({"run", tour, "--werror"});
  CHECK(outcome.errors == "");
  CHECK(outcome.exit_code == 0);
}

TEST_CASE("the README's control loop prints its line") {
  const ScratchDirectory scratch;
  write_file(scratch / "control.cpp", block("cpp", 1));
  REQUIRE(run_mbcc({model.string(), "--library", "-o", scratch / "planar_pendulum.hpp"}).exit_code == 0);
  std::vector<std::string> arguments = {"-std=c++20", "-I" MBCC_SOURCE_DIR "/runtime/include"};
  std::istringstream build_flags(MBCC_CXX_FLAGS);  // sanitizers, which the runtime was built with
  for (std::string flag; build_flags >> flag;) {
    arguments.push_back(flag);
  }
  for (const std::string& argument : {(scratch / "control.cpp").string(), std::string(MBCC_RUNTIME_LIBRARY),
                                      std::string("-o"), (scratch / "control").string()}) {
    arguments.push_back(argument);
  }
  const Outcome built = run_program(MBCC_CXX, arguments);
  INFO(built.errors);
  REQUIRE(built.exit_code == 0);
  CHECK(run_program(scratch / "control", {}).output == block("text", 2));
}
