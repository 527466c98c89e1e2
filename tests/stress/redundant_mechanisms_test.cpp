// Bricard's mechanism: a loop of six hinges that is rigid by count (39 rows for 39 speeds) and moves nonetheless. One
// row always follows from the others, never the same combination of them: no fixed choice of rows is right.

#include "models/published_model.hpp"
#include "runs.hpp"

namespace mbcc::test {
namespace {

void check_bricard(const std::string& method, double tolerance) {
  const PublishedModel model("iftomm_a04_bricard");
  INFO(method << " at " << tolerance);
  const std::vector<std::string> flags = {"--method", method, "--tolerance", flag(tolerance)};
  const Run run = model.run(flags);
  REQUIRE(run.exit_code == 0);
  CHECK(run.summary["rank"]["minimum"] == 38);
  CHECK(run.summary["rank"]["changes"] == 1);  // found at the start, once and for all
  CHECK(run.summary["steps"] < 400);           // 270 at 1e-12 with the row taken out by hand
  // The errors of the steps add up, and two swings of ten seconds do not amplify them much.
  CHECK(model.error(model.end(flags)) < 300 * tolerance + 1e-12);
  for (const auto& [constraint, errors] : run.summary["constraints"].items()) {
    INFO(constraint);
    // Squared lengths near 1, sums of twelve terms; and what one step of Newton's method leaves of a step's error: its
    // square.
    CHECK(errors["position"] < 16 * eps + std::pow(8 * tolerance, 2));
    CHECK(errors["velocity"] < 16 * eps);
  }
}

}  // namespace

TEST_CASE("Bricard: redundant throughout") { check_bricard("dop853", 1e-9); }

TEST_CASE("Bricard: at every tolerance", "[full]") {
  for (const std::string& method : adaptive_methods) {
    for (int exponent = 5; exponent <= 12; ++exponent) {
      check_bricard(method, std::pow(10.0, -exponent));
    }
  }
}

}  // namespace mbcc::test
