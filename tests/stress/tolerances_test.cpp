// The paper's example at every tolerance: t = 3, where the second particle loses a row, is no obstacle, and errors
// follow the tolerance all the way down to rounding.

#include "runs.hpp"

namespace mbcc::test {
namespace {

void check_tolerance(const std::string& method, int exponent) {
  constexpr double exact = 0.07287998710974598;  // z1(5), by elliptic functions
  const double tolerance = std::pow(10.0, -exponent);
  INFO(method << " at " << tolerance);
  const Run run = completed(example_model("artigo5"), method, tolerance);
  // dop853's steps grow by 10^(1/8) for each digit from 30 at 1e-3, those of taylor less; far below any collapse.
  CHECK(run.summary["steps"] < 100 + 40 * std::pow(10, (exponent - 3) / 8.0));
  CHECK(std::abs(run.final_value("z1") - exact) < 1000 * tolerance + 1e-13);  // rounding of some 600 steps
  CHECK(std::abs(run.final_value("z2") - 0.5) < 1e-14 * run.summary["steps"].get<double>());
  CHECK(run.constraint_error("constraint_3", "velocity") == 0);
  CHECK(run.constraint_error("constraint_4", "velocity") == 0);
}

}  // namespace

TEST_CASE("tolerances: the paper's example passes t = 3 at all of them") {
  for (const std::string method : {"dop853", "taylor", "auto"}) {
    for (int exponent = 3; exponent <= 15; ++exponent) {
      check_tolerance(method, exponent);
    }
  }
}

}  // namespace mbcc::test
