#pragma once
// Runs a scene of scenes.hpp as its user would. The test target defines SAMPLES, the path of the program.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/run_program.hpp"

namespace mbrt::test {

/// A finished run: exit code, output, errors; its rows and its summary (null if it wrote none).
struct SampleRun : mbcc::test::Outcome {
  std::string csv;
  mbcc::test::Table table;
  nlohmann::json summary;

  double final_value(const std::string& name) const { return summary.at("final").at(name).get<double>(); }
  double largest(const std::string& constraint, const std::string& level) const {
    return summary.at("constraints").at(constraint).at(level).get<double>();
  }
};

/// `samples scene arguments...`, for tests of what it prints.
inline mbcc::test::Outcome run_plain(const std::string& scene, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), scene);
  return mbcc::test::run_program(SAMPLES, arguments);
}

/// The same with --csv and --summary.
inline SampleRun run_sample(const std::string& scene, std::vector<std::string> arguments = {}) {
  const mbcc::test::ScratchDirectory scratch;
  for (const char* const argument : {"--csv", "--summary"}) {
    arguments.emplace_back(argument);
    arguments.push_back(scratch / (argument + 2));
  }
  SampleRun run{run_plain(scene, arguments), {}, {}, {}};
  run.csv = mbcc::test::read_file(scratch / "csv");
  run.table = mbcc::test::parse_csv(run.csv);
  run.summary = nlohmann::json::parse(mbcc::test::read_file(scratch / "summary"), nullptr, false);
  if (run.summary.is_discarded()) {
    run.summary = nullptr;
  }
  return run;
}

}  // namespace mbrt::test
