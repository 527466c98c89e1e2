// Systems made of parts: they move as the same systems do that are written down in one piece.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {

TEST_CASE("chain of pendulums: with ten of them, the reference end state of the chain") {
  std::string text = read_file(example("pendulum_chain"));
  const std::string count = "constant N = 20";
  REQUIRE(text.find(count) != std::string::npos);
  text.replace(text.find(count), count.size(), "constant N = 10");
  const ScratchDirectory scratch;
  write_file(scratch / "ten.mbd", text);
  const Run ten = run_model(scratch / "ten.mbd");
  INFO(ten.errors);
  REQUIRE(ten.exit_code == 0);
  // In quadruple precision, as for the example `chain`, with RK4's error at this step.
  CHECK(ten.table.last("link[10].bob.x") == near(-7.5371994054581429, 1e-8));
  CHECK(ten.table.last("link[10].bob.y") == near(-2.5705531392991957, 1e-8));
  CHECK(ten.table.last("link[10].bob.z") == near(-5.933961553716337, 1e-8));
}

TEST_CASE("double spherical pendulum: spin is kept; without a push it is the planar double pendulum") {
  const Table pushed = run_example("double_spherical_pendulum").table;
  for (const double spin : pushed["spin"]) {
    REQUIRE(spin == near(4, 1e-10));  // RK4 at this step loses 9e-12
  }
  const Table flat = run_example("double_spherical_pendulum", {"--set", "push=0"}).table;
  const nlohmann::json end = nlohmann::json::parse(
      read_file(std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models/references.json"))["double_pendulum"]["end"];
  // RK4 at this step is 6e-8 off; the motion is chaotic, and another compiler's rounding takes it elsewhere.
  const double tolerance = 1e-6;
  CHECK(flat.last("upper.bob.x") == near(end["x1"], tolerance));
  CHECK(flat.last("upper.bob.z") == near(end["y1"], tolerance));
  CHECK(flat.last("lower.bob.x") == near(end["x2"], tolerance));
  CHECK(flat.last("lower.bob.z") == near(end["y2"], tolerance));
  CHECK(flat.last("lower.bob.y") == 0);
}

TEST_CASE("five-bar mechanism: angular accelerations at the start, by another formulation; mirror symmetry") {
  const Table table = run_example("five_bar").table;
  const double printed = 1e-8;  // the reference's last digit
  CHECK(table["load.y"].front() == near(0.571501570, 1e-9));
  CHECK(table["left.upper.acceleration"].front() == near(20.31175697, printed));
  CHECK(table["left.lower.acceleration"].front() == near(-14.97660761, printed));
  CHECK(table["right.upper.acceleration"].front() == near(-20.31175697, printed));
  CHECK(table["right.lower.acceleration"].front() == near(14.97660761, printed));
  for (const double aside : table["load.x"]) {
    REQUIRE(std::abs(aside) < 1e-14);  // rounding
  }
}

}  // namespace mbcc::test
