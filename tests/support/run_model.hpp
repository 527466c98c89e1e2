#pragma once
// Runs the real mbcc and reads its results. The test target defines MBCC_BINARY, the path of the program.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_program.hpp"

namespace mbcc::test {

inline Outcome run_mbcc(const std::vector<std::string>& arguments) { return run_program(MBCC_BINARY, arguments); }

/// A finished `mbcc run`: its outcome, its rows, and its summary (null if it wrote none).
struct Run : Outcome {
  Table table;
  nlohmann::json summary;

  /// The largest absolute value that the monitors saw; `level` is "position", "velocity" or "acceleration".
  [[nodiscard]] double constraint_error(const std::string& name, const std::string& level) const {
    return summary.at("constraints").at(name).at(level).get<double>();
  }
  [[nodiscard]] double final_value(const std::string& name) const { return summary.at("final").at(name).get<double>(); }
};

/// `mbcc run model --csv ... --summary ... flags...`.
inline Run run_model(const std::filesystem::path& model, const std::vector<std::string>& flags = {}) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments = {"run",       model.string(),          "--csv", scratch / "result.csv",
                                        "--summary", scratch / "summary.json"};
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  Run run{run_mbcc(arguments), {}, {}};
  run.table = parse_csv(read_file(scratch / "result.csv"));
  run.summary = nlohmann::json::parse(read_file(scratch / "summary.json"), nullptr, false);
  if (run.summary.is_discarded()) {
    run.summary = nullptr;
  }
  return run;
}

}  // namespace mbcc::test
