#include "driver/subject.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace mbcc {

namespace {

/// The NAME=VALUE of every `--set`, read as the simulation reads them.
std::vector<std::string> settings_in(std::vector<std::string> flags) {
  CLI::App app;
  app.allow_extras();
  app.set_help_flag();
  std::vector<std::string> settings;
  app.add_option("--set", settings);
  std::reverse(flags.begin(), flags.end());  // as CLI11 takes them
  app.parse(flags);
  return settings;
}

void apply(const std::string& setting, const model::System& system, mechanics::Point& point) {
  const std::size_t equals = setting.find('=');
  for (std::size_t i = 0; i < system.parameters.size(); ++i) {
    if (system.parameters[i].name == setting.substr(0, equals)) {
      point.parameters[i] = std::strtod(setting.c_str() + equals + 1, nullptr);
    }
  }
}

}  // namespace

Subject subject_of_run(const Compilation& compilation, const std::string& model,
                       const std::vector<std::string>& flags) {
  const model::System& system = *compilation.system;
  mechanics::Point point = mechanics::initial_point(system, compilation.equations);
  for (const std::string& setting : settings_in(flags)) {
    apply(setting, system, point);
  }
  return {system.name, model == "-" ? "standard input" : model,
          page::skeleton_of(system, compilation.equations, compilation.derivatives, point)};
}

Subject subject_of_file(const std::string& path) { return {std::filesystem::path(path).stem().string(), path, {}}; }

}  // namespace mbcc
