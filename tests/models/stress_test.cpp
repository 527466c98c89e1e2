// Long and hard runs of published models.

#include "published_model.hpp"

namespace mbcc::test {

TEST_CASE("a pendulum of 1e5 periods stays on its circle") {
  const std::filesystem::path pendulum =
      std::filesystem::path(MBCC_SOURCE_DIR) / "examples/planar_pendulum/planar_pendulum.mbd";
  // The period of a swing of pi/3 is 2.1531 s. --every keeps the file small.
  const Run run = run_model(pendulum, {"--method", "dop853", "--to", "215310", "--every", "215310"});
  REQUIRE(run.exit_code == 0);
  CHECK(run.constraint_error("rod", "position") < 1e-13);
  CHECK(run.constraint_error("rod", "velocity") < 1e-13);
}

TEST_CASE("the paper's example passes the loss of rank at every tolerance") {
  const std::filesystem::path paper = std::filesystem::path(MBCC_SOURCE_DIR) / "examples/artigo5/artigo5.mbd";
  constexpr double exact = 0.07287998710974598;  // z1(5), by elliptic functions
  for (int exponent = 3; exponent <= 14; ++exponent) {
    const double tolerance = std::pow(10.0, -exponent);
    const Run run = run_model(paper, {"--method", "dop853", "--tolerance", flag(tolerance)});
    INFO("tolerance " << tolerance);
    REQUIRE(run.exit_code == 0);
    // Steps grow by 10^(1/8) for each digit from 30 at 1e-3: far below any collapse.
    CHECK(run.summary["steps"] < 40 * std::pow(10, (exponent - 3) / 8.0));
    CHECK(std::abs(run.final_value("z1") - exact) < 200 * tolerance + 1e-13);  // rounding of 600 steps
    CHECK(std::abs(run.final_value("z2") - 0.5) < 1e-14 * run.summary["steps"].get<double>());
    CHECK(run.constraint_error("constraint_3", "velocity") == 0);
    CHECK(run.constraint_error("constraint_4", "velocity") == 0);
  }
}

}  // namespace mbcc::test
