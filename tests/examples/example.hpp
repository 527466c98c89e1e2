#pragma once
// Runs an example by its name.

#include <filesystem>
#include <string>
#include <vector>

#include "support/accuracy.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {

inline std::filesystem::path example(const std::string& name) {
  return std::filesystem::path(MBCC_SOURCE_DIR) / "examples" / name / (name + ".mbd");
}

inline Run run_example(const std::string& name, const std::vector<std::string>& flags = {}) {
  Run run = run_model(example(name), flags);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return run;
}

/// Largest departure of the energy from its start, at a step.
inline double energy_drift(const std::string& name, const std::string& step) {
  return run_example(name, {"--step", step}).summary.at("energy").at("max_drift").get<double>();
}

}  // namespace mbcc::test
