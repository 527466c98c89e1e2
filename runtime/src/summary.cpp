#include "summary.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "columns.hpp"
#include "mbrt/radau.hpp"
#include "mbrt/taylor.hpp"
#include "methods.hpp"

namespace mbrt {
namespace {

using Json = nlohmann::ordered_json;  // writes what is not finite as null

Json final_json(const Description& model, const Outcome& outcome) {
  Json values = {{"t", outcome.time}};
  for (const std::size_t i : declared_order(model)) {
    values[state_name(model, i)] = outcome.state[i];
  }
  return values;
}

Json constraints_json(const Description& model, const Findings& findings) {
  Json constraints = Json::object();
  for (std::size_t i = 0; i < findings.constraints.size(); ++i) {
    const LargestErrors& largest = findings.constraints[i];
    Json& entry = constraints[model.constraints[i].name];
    if (model.constraints[i].holonomic) {
      entry["position"] = largest.position;
    }
    entry["velocity"] = largest.velocity;
    entry["acceleration"] = largest.acceleration;
  }
  return constraints;
}

Json event_json(const Description& model, const RankEvent& event) {
  Json names = Json::array();
  for (const int constraint : model.islands[event.island].constraints) {
    names.push_back(model.constraints[static_cast<std::size_t>(constraint)].name);
  }
  const std::size_t of = names.size();
  return {{"time", event.time}, {"rank", event.rank}, {"of", of}, {"constraints", std::move(names)}};
}

Json rank_json(const Description& model, const Outcome& outcome) {
  Json events = Json::array();
  for (const RankEvent& event : outcome.findings.rank_events) {
    events.push_back(event_json(model, event));
  }
  return {{"minimum", outcome.findings.smallest_rank},
          {"of", model.constraints.size()},
          {"changes", outcome.findings.rank_changes},
          {"events", std::move(events)}};
}

Json solver_json(const Outcome& outcome) {
  Json islands = Json::object();
  for (std::size_t k = 0; k < outcome.solves.size(); ++k) {
    const IslandRecord& record = outcome.solves[k];
    islands[fmt::format("island_{}", k + 1)] = {{"ldlt", outcome.evaluations - record.refined - record.pinv},
                                                {"refined", record.refined},
                                                {"pinv", record.pinv}};
  }
  return islands;
}

}  // namespace

std::string summary_json(const Description& model, const Options& options, const Outcome& outcome) {
  Json summary = {{"model", model.model}, {"mbcc_version", model.mbcc_version}, {"status", name(outcome.status)}};
  if (!outcome.message.empty()) {
    summary["message"] = outcome.message;
  }
  summary["method"] = options.method;
  const bool chooses_step = find_method(options.method)->chooses_step;
  if (chooses_step) {
    summary["tolerance"] = options.tolerance;
  }
  summary["steps"] = outcome.steps;
  summary["evaluations"] = outcome.evaluations;
  if (chooses_step) {
    summary["rejected"] = outcome.rejected;
  }
  if (options.method == Taylor::name) {
    summary["fallbacks"] = outcome.fallbacks;
  }
  if (!std::isnan(outcome.stiff_from)) {
    summary["stiff_from"] = outcome.stiff_from;
  }
  if (options.method == Radau::name || outcome.jacobians > 0) {
    summary["jacobians"] = outcome.jacobians;
    summary["differenced"] = outcome.differenced;
    summary["factorisations"] = outcome.factorisations;
  }
  if (options.project && !outcome.solves.empty()) {
    summary["projections"] = outcome.projections;
  }
  summary["wall_seconds"] = outcome.wall_seconds;
  summary["monitored"] = outcome.monitored;
  summary["final"] = final_json(model, outcome);
  const Findings& findings = outcome.findings;
  if (!findings.constraints.empty()) {
    summary["constraints"] = constraints_json(model, findings);
  }
  if (model.has_energy) {
    summary["energy"] = {
        {"initial", findings.initial_energy}, {"final", findings.final_energy}, {"max_drift", findings.energy_drift}};
  }
  if (!outcome.solves.empty()) {
    summary["rank"] = rank_json(model, outcome);
    summary["solver"] = solver_json(outcome);
  }
  return summary.dump(2) + "\n";
}

}  // namespace mbrt
