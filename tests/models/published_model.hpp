#pragma once
// The published models and their trusted end states.

#include <catch2/catch.hpp>
#include <map>

#include "support/accuracy.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {

inline const std::filesystem::path models_folder = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models";

/// One published model, its trusted end state, and runs of it at several steps.
class PublishedModel {
 public:
  explicit PublishedModel(const std::string& name) : path_(models_folder / (name + ".mbd")) {
    reference_ = nlohmann::json::parse(read_file(models_folder / "references.json")).at(name);
  }

  /// A run to the reference's time.
  [[nodiscard]] Run run(std::vector<std::string> flags) const {
    for (const std::string& word :
         {std::string("--to"), flag(reference_["time"]), std::string("--every"), flag(reference_["time"])}) {
      flags.push_back(word);
    }
    return run_model(path_, flags);
  }

  /// Its end state, checked to be at the reference's time.
  [[nodiscard]] std::map<std::string, double> end(const std::vector<std::string>& flags) const {
    const Run run = this->run(flags);
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    return end_of(run);
  }

  /// That of a run which has come there.
  [[nodiscard]] std::map<std::string, double> end_of(const Run& run) const {
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

}  // namespace mbcc::test
