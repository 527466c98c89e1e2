// The published models with projection: adaptive steps that keep their tolerance, and singular positions.

#include "published_model.hpp"

namespace mbcc::test {
namespace {

/// Errors grow along the way, most where bodies pass each other: to no more than this many tolerances, in
/// the models that are tested here.
constexpr double growth = 100;

void check_follows_tolerance(const std::string& name) {
  const PublishedModel model(name);
  double last = 1;
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const double error = model.error(model.end({"--method", "dop853", "--tolerance", flag(tolerance)}));
    INFO(name << " at " << tolerance << ": error " << error);
    CHECK(error < growth * tolerance);
    CHECK(error < last / 100);  // of a factor of 1000
    last = error;
  }
}

}  // namespace

TEST_CASE("car axis: the error follows the tolerance") { check_follows_tolerance("ivp_caraxis"); }
TEST_CASE("Andrews' mechanism: the error follows the tolerance") { check_follows_tolerance("ivp_andrews"); }
TEST_CASE("Pleiades: the error follows the tolerance") { check_follows_tolerance("ivp_pleiades"); }
TEST_CASE("the textbook's four-bar does not drift") {
  check_follows_tolerance("textbook_fourbar_t10");
  const Run run = PublishedModel("textbook_fourbar_t10").run({"--method", "dop853"});
  for (const auto& [constraint, errors] : run.summary["constraints"].items()) {
    CHECK(errors["position"] < 1e-13);  // bars of length up to 2.5: a few roundings
    CHECK(errors["velocity"] < 1e-13);
  }
}

TEST_CASE("two four-bars pass their singular positions with projection, on constant steps") {
  const PublishedModel model("iftomm_a02_fourbar2");
  // Published for rk4 with projection of position and velocity: 8e-5 at 0.01, 6e-8 at 0.002.
  CHECK(model.error(model.end({"--step", "0.01", "--project", "on"})) < 8e-5);
  CHECK(model.error(model.end({"--step", "0.002", "--project", "on"})) < 6e-8);
}

TEST_CASE("two four-bars pass their singular positions on steps of the method's choice") {
  const PublishedModel model("iftomm_a02_fourbar2");
  for (const double tolerance : {1e-6, 1e-9, 1e-10}) {
    const Run run = model.run({"--method", "dop853", "--tolerance", flag(tolerance)});
    REQUIRE(run.exit_code == 0);
    CHECK(run.summary["steps"] < 500);  // no collapse on the way: 290 without singular positions in it
    CHECK(model.error(model.end({"--method", "dop853", "--tolerance", flag(tolerance)})) < 300 * tolerance);
  }
}

TEST_CASE("Bricard's mechanism, redundant throughout") {
  const PublishedModel model("iftomm_a04_bricard");
  const Run run = model.run({"--method", "dop853"});
  REQUIRE(run.exit_code == 0);
  CHECK(run.summary["rank"]["minimum"] == 38);
  CHECK(model.error(model.end({"--method", "dop853"})) < 300 * 1e-9);
}

}  // namespace mbcc::test
