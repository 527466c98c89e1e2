// The flyball governor: springs of 8e5 N/m with dampers of 4e4 Ns/m at masses down to 0.05 kg. The fastest mode decays
// at 27000/s, so that explicit steps are limited to its stability and not to what the motion needs: a step of dop853
// may be some 6/27000 s long. What must hold is that this costs time alone: the end is the reference's.

#include "models/published_model.hpp"
#include "runs.hpp"

namespace mbcc::test {
namespace {

/// Those that are to come to the end of the governor's ten seconds.
const std::vector<std::string> methods_for_stiffness = {"dop853", "taylor"};

}  // namespace

TEST_CASE("flyball governor: ten seconds of a stiff motion") {
  const PublishedModel model("iftomm_a05_flyball_particles");
  constexpr double tolerance = 1e-6;
  std::map<std::string, Run> runs;
  for (const std::string& method : methods_for_stiffness) {
    INFO(method);
    const Run& run = runs[method] = model.run({"--method", method, "--tolerance", flag(tolerance)});
    REQUIRE(run.exit_code == 0);
    // The dampers let errors fade: what is left is that of the steps of a few periods.
    CHECK(model.error(model.end_of(run)) < 100 * tolerance);
  }
  // The masses differ so much that islands are hard to solve, and there is no series anywhere: `taylor` takes the steps
  // of dop853, and tries for a series in every sixteenth of them, beside twelve evaluations in each.
  const nlohmann::json& series = runs["taylor"].summary;
  const nlohmann::json& plain = runs["dop853"].summary;
  CHECK(series["fallbacks"] == series["steps"]);
  CHECK(series["steps"] == plain["steps"]);
  CHECK(series["evaluations"].get<double>() < 1.1 * plain["evaluations"].get<double>() + 100);
}

}  // namespace mbcc::test
