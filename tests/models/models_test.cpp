// The published models: those that classical RK4 can integrate reach their trusted end state within the method's error,
// and show its order; the others are accepted, compile and start.

#include "published_model.hpp"

namespace mbcc::test {
namespace {

/// Integrates at `step` and at half of it. Each case's step is chosen so that the leading term of RK4's error stands
/// clear of the next term above and of rounding below.
void check_fourth_order(const std::string& name, double step) {
  const PublishedModel model(name);
  std::map<std::string, double> coarse = model.end({"--step", flag(step)});
  std::map<std::string, double> fine = model.end({"--step", flag(step / 2)});
  const double error = model.error(fine);
  INFO("error " << model.error(coarse) << ", at half the step " << error);
  CHECK(observed_order(model.error(coarse), error) == near(4, 0.2));
  CHECK(error < 1e-6);
  // What is left when the leading term is removed is of higher order, so the difference was the method's own.
  std::map<std::string, double> extrapolated;
  for (const auto& [quantity, value] : fine) {
    extrapolated[quantity] = value + (value - coarse[quantity]) / 15;
  }
  CHECK(model.error(extrapolated) < 0.2 * error);
}

void check_starts(const std::string& name, double step) {
  const std::string path = models_folder / (name + ".mbd");
  const Outcome check = run_mbcc({"check", path});
  INFO(check.errors);
  CHECK(check.exit_code == 0);
  const Run run = run_model(path, {"--step", flag(step), "--to", flag(step)});
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  CHECK(run.summary["status"] == "ok");
  CHECK(run.summary["steps"] == 1);
}

}  // namespace

TEST_CASE("car axis") { check_fourth_order("ivp_caraxis", 0.0005); }
TEST_CASE("Andrews' squeezing mechanism") { check_fourth_order("ivp_andrews", 1e-5); }
TEST_CASE("elliptic Fekete points, transient") { check_fourth_order("ivp_fekete_t10", 0.02); }
TEST_CASE("Pleiades") { check_fourth_order("ivp_pleiades", 5e-5); }
TEST_CASE("outer solar system") { check_fourth_order("outer_solar_system", 0.0125); }
TEST_CASE("Kepler orbit, eccentricity 0.1") { check_fourth_order("enright_pryce_d1", 0.01); }
TEST_CASE("Kepler orbit, eccentricity 0.5") { check_fourth_order("enright_pryce_d3", 0.005); }
TEST_CASE("Kepler orbit, eccentricity 0.9") { check_fourth_order("enright_pryce_d5", 0.00025); }
TEST_CASE("pendulum A01") { check_fourth_order("iftomm_a01_pendulum", 0.0025); }
TEST_CASE("knife edge") { check_fourth_order("knife_edge", 0.02); }
TEST_CASE("bead on a helix") { check_fourth_order("helix_bead", 0.004); }
TEST_CASE("Viviani's curve") { check_fourth_order("viviani_t3", 0.02); }
TEST_CASE("spherical pendulum") { check_fourth_order("spherical_pendulum", 0.005); }
TEST_CASE("pendulum with its constraint three times") { check_fourth_order("redundant_pendulum", 0.0025); }
TEST_CASE("linear chain") { check_fourth_order("linear_chain", 0.02); }
TEST_CASE("particle on a wavy surface") { check_fourth_order("uk_surface", 0.002); }
TEST_CASE("four-bar of the textbook") { check_fourth_order("textbook_fourbar_t10", 0.002); }

TEST_CASE("double pendulum") { check_fourth_order("double_pendulum", 0.0005); }
TEST_CASE("two four-bars before the singular position") {
  check_fourth_order("iftomm_a02_fourbar2_presingular", 0.004);
}
TEST_CASE("Bricard's mechanism, its fall") { check_fourth_order("iftomm_a04_bricard_t1", 0.01); }

TEST_CASE("two four-bars start") { check_starts("iftomm_a02_fourbar2", 0.001); }
TEST_CASE("Bricard's mechanism starts") { check_starts("iftomm_a04_bricard", 0.001); }
TEST_CASE("flyball governor starts") { check_starts("iftomm_a05_flyball_particles", 1e-5); }
TEST_CASE("Fekete points to rest start") { check_starts("ivp_fekete", 0.01); }

}  // namespace mbcc::test
