// The published models: those that classical RK4 can integrate reach their trusted end state within the method's error,
// and show its order; the others are accepted, compile and start.

#include <catch2/catch.hpp>
#include <map>

#include "support/accuracy.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models";

/// One published model, its trusted end state, and runs of it at several steps.
class PublishedModel {
 public:
  explicit PublishedModel(const std::string& name) : path_(folder / (name + ".mbd")) {
    reference_ = nlohmann::json::parse(read_file(folder / "references.json")).at(name);
  }

  /// The end state at a step, checked to be at the reference's time.
  [[nodiscard]] std::map<std::string, double> end(double step) const {
    const Run run = run_model(path_, {"--step", flag(step), "--every", flag(reference_["time"])});
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    REQUIRE(run.table.last("t") == near(reference_["time"], 1e-12));  // n steps round to the end within n ulps
    std::map<std::string, double> state;
    for (const auto& [name, unused] : reference_["end"].items()) {
      state[name] = run.table.last(name);
    }
    return state;
  }

  /// Largest distance from the reference, positions and velocities each in units of their own largest one.
  [[nodiscard]] double error(const std::map<std::string, double>& state) const {
    double largest = 0;
    for (const auto& [name, value] : state) {
      largest = std::max(largest, std::abs(value - reference_["end"][name].get<double>()) / size(is_velocity(name)));
    }
    return largest;
  }

 private:
  static bool is_velocity(const std::string& name) { return name[name.find('.') + 1] == 'v'; }

  [[nodiscard]] double size(bool velocities) const {
    double largest = 0;
    for (const auto& [name, value] : reference_["end"].items()) {
      if (is_velocity(name) == velocities) {
        largest = std::max(largest, std::abs(value.get<double>()));
      }
    }
    return largest;
  }

  std::filesystem::path path_;
  nlohmann::json reference_;
};

/// Integrates at `step` and at half of it. Each case's step is chosen so that the leading term of RK4's error stands
/// clear of the next term above and of rounding below.
void check_fourth_order(const std::string& name, double step) {
  const PublishedModel model(name);
  std::map<std::string, double> coarse = model.end(step);
  std::map<std::string, double> fine = model.end(step / 2);
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
  const std::string path = folder / (name + ".mbd");
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
