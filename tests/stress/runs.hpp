#pragma once
// What the cases share: models written in a test or kept beside it, run by every method that chooses its steps.

#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "support/accuracy.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {

/// Those that a scene without stiffness may be given to.
inline const std::vector<std::string> adaptive_methods = {"dop853", "taylor"};

inline constexpr double eps = std::numeric_limits<double>::epsilon();

inline std::filesystem::path stress_model(const std::string& name) {
  return std::filesystem::path(MBCC_SOURCE_DIR) / "tests/stress/models" / (name + ".mbd");
}

inline std::filesystem::path example_model(const std::string& name) {
  return std::filesystem::path(MBCC_SOURCE_DIR) / "examples" / name / (name + ".mbd");
}

/// A run that is to come to its end.
inline Run completed(const std::filesystem::path& model, const std::vector<std::string>& flags) {
  Run run = run_model(model, flags);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  REQUIRE(run.summary["status"] == "ok");
  return run;
}

/// The same with a method and a tolerance.
inline Run completed(const std::filesystem::path& model, const std::string& method, double tolerance,
                     std::vector<std::string> flags = {}) {
  flags.insert(flags.end(), {"--method", method, "--tolerance", flag(tolerance)});
  return completed(model, flags);
}

}  // namespace mbcc::test
