#include "summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

namespace mbrt {
namespace {

using Json = nlohmann::ordered_json;  // writes what is not finite as null

constexpr const char* status_name(Status status) {
  switch (status) {
    case Status::Ok:
      return "ok";
    case Status::Failed:
      return "failed";
    case Status::Interrupted:
      return "interrupted";
  }
  return "";
}

Json final_json(const Description& model, const Outcome& outcome) {
  Json values = {{"t", outcome.time}};
  std::size_t i = 0;
  for (const auto names : {model.coordinates, model.speeds}) {
    for (const char* const name : names) {
      values[name] = outcome.state[i++];
    }
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

/// Of all constraints together, over all evaluations.
int smallest_rank(const Outcome& outcome) {
  return std::accumulate(outcome.solves.begin(), outcome.solves.end(), 0,
                         [](int sum, const IslandRecord& record) { return sum + record.smallest_rank; });
}

Json rank_json(const Description& model, const Outcome& outcome) {
  Json events = Json::array();
  for (const RankEvent& event : outcome.findings.rank_events) {
    events.push_back(event_json(model, event));
  }
  return {{"minimum", smallest_rank(outcome)},
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

void append_constraints(std::string& text, const Description& model, const Findings& findings) {
  constexpr std::size_t most_lines = 12;
  const auto out = std::back_inserter(text);
  std::size_t width = 18;
  for (const ConstraintEntry& constraint : model.constraints) {
    width = std::max(width, std::string_view(constraint.name).size());
  }
  fmt::format_to(out, "  {:{}}  {:>13} {:>13} {:>13}\n", "largest errors of", width, "position", "velocity",
                 "acceleration");
  for (std::size_t i = 0; i < std::min(most_lines, findings.constraints.size()); ++i) {
    const LargestErrors& largest = findings.constraints[i];
    const std::string position = model.constraints[i].holonomic ? fmt::format("{:.6e}", largest.position) : "";
    fmt::format_to(out, "  {:{}}  {:>13} {:>13.6e} {:>13.6e}\n", model.constraints[i].name, width, position,
                   largest.velocity, largest.acceleration);
  }
  if (findings.constraints.size() > most_lines) {
    fmt::format_to(out, "  and {} more\n", findings.constraints.size() - most_lines);
  }
}

/// "`a`, `b`, `c` and 7 more".
std::string names_of(const Description& model, std::span<const int> constraints) {
  constexpr std::size_t most_names = 3;
  std::string text;
  for (const int constraint : constraints.first(std::min(most_names, constraints.size()))) {
    text +=
        fmt::format("{}`{}`", text.empty() ? "" : ", ", model.constraints[static_cast<std::size_t>(constraint)].name);
  }
  return constraints.size() > most_names ? fmt::format("{} and {} more", text, constraints.size() - most_names) : text;
}

void append_rank_events(std::string& text, const Description& model, const Findings& findings) {
  constexpr long most_lines = 10;
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < std::min<std::size_t>(most_lines, findings.rank_events.size()); ++i) {
    const RankEvent& event = findings.rank_events[i];
    const auto constraints = model.islands[event.island].constraints;
    fmt::format_to(out, "  rank {} of {} from t = {:.9g}: {}\n", event.rank, constraints.size(), event.time,
                   names_of(model, constraints));
  }
  if (findings.rank_changes > most_lines) {
    fmt::format_to(out, "  and {} more changes of rank\n", findings.rank_changes - most_lines);
  }
}

}  // namespace

std::string summary_json(const Description& model, const Outcome& outcome) {
  Json summary = {
      {"model", model.model}, {"mbcc_version", model.mbcc_version}, {"status", status_name(outcome.status)}};
  if (!outcome.message.empty()) {
    summary["message"] = outcome.message;
  }
  summary["method"] = "rk4";
  summary["steps"] = outcome.steps;
  summary["evaluations"] = outcome.evaluations;
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

std::string summary_text(const Description& model, const Options& options, const Outcome& outcome) {
  const Findings& findings = outcome.findings;
  std::string text = fmt::format("{}: {}, rk4, {} steps of {} from t = {} to {:.9g} in {:.3g} s{}\n", model.model,
                                 status_name(outcome.status), outcome.steps, options.step, options.from, outcome.time,
                                 outcome.wall_seconds, outcome.monitored ? "" : " unobserved");
  if (!findings.constraints.empty()) {
    append_constraints(text, model, findings);
    append_rank_events(text, model, findings);
  }
  if (model.has_energy) {
    fmt::format_to(std::back_inserter(text), "  energy {:.6g}, largest drift {:.3g}\n", findings.initial_energy,
                   findings.energy_drift);
  }
  return text;
}

}  // namespace mbrt
