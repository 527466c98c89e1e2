#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <vector>

#include "durations.hpp"
#include "mbrt/radau.hpp"
#include "methods.hpp"

namespace mbrt {
namespace {

constexpr std::size_t most_constraints = 12;
constexpr std::size_t most_lines = 10;  // of anything else

std::string counted(long number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
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

class Report {
 public:
  Report(const Description& model, const Options& options, const Outcome& outcome)
      : model_(model), options_(options), outcome_(outcome), findings_(outcome.findings) {}

  std::string write() {
    headline();
    if (outcome_.fallbacks > 0) {
      line("{} left to `dop853`, where there is no series", counted(outcome_.fallbacks, "step"));
    }
    stiffness();
    if (outcome_.jacobians > 0) {
      line("{}{}, {}", counted(outcome_.jacobians, "Jacobian"),
           outcome_.differenced == 0 ? "" : fmt::format(" ({} by differences)", outcome_.differenced),
           counted(outcome_.factorisations, "factorisation"));
    }
    if (!findings_.constraints.empty()) {
      constraint_errors();
      rank_events();
      ladder_counts();
    }
    if (model_.has_energy && outcome_.evaluations > 0) {
      line("energy {:.6g}, largest drift {:.3g}", findings_.initial_energy, findings_.energy_drift);
    }
    return std::move(text_);
  }

 private:
  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += "  ";
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    text_ += '\n';
  }

  void headline() {
    const std::string end = outcome_.time == options_.to ? "" : fmt::format(" of {:.9g}", options_.to);
    text_ = fmt::format("{}: {}, {}, {} from t = {} to {:.9g}{} in {}{}\n", model_.model, name(outcome_.status),
                        options_.method + (options_.chosen_by_auto ? " by auto" : ""), steps(), options_.from,
                        outcome_.time, end, duration(outcome_.wall_seconds), outcome_.monitored ? "" : " unobserved");
  }

  void stiffness() {
    if (std::isnan(outcome_.stiff_from)) {
      return;
    }
    if (outcome_.jacobians > 0) {
      line("`{}` from t = {:.9g} on, where the motion is stiff", Radau::name, outcome_.stiff_from);
    } else {
      line("stiff from t = {:.9g} on: `--method {}` takes longer steps", outcome_.stiff_from, Radau::name);
    }
  }

  /// "1000 steps of 0.005", "80 steps (3 more rejected) to tolerance 1e-09".
  std::string steps() const {
    const std::string accepted = counted(outcome_.steps, "step");
    if (!find_method(options_.method)->chooses_step) {
      return fmt::format("{} of {}", accepted, options_.step);
    }
    return fmt::format("{}{} to tolerance {}", accepted,
                       outcome_.rejected == 0 ? "" : fmt::format(" ({} more rejected)", outcome_.rejected),
                       options_.tolerance);
  }

  /// One line each; of many constraints those with the largest errors, in the order of the model.
  void constraint_errors() {
    const std::vector<std::size_t> shown = constraints_shown();
    std::size_t width = 18;
    for (const std::size_t i : shown) {
      width = std::max(width, std::string_view(model_.constraints[i].name).size());
    }
    line("{:{}}  {:>13} {:>13} {:>13}", "largest errors of", width, "position", "velocity", "acceleration");
    for (const std::size_t i : shown) {
      const LargestErrors& largest = findings_.constraints[i];
      line("{:{}}  {:>13} {:>13} {:>13}", model_.constraints[i].name, width,
           model_.constraints[i].holonomic ? error(largest.position) : "", error(largest.velocity),
           error(largest.acceleration));
    }
    if (const std::size_t all = findings_.constraints.size(); all > shown.size()) {
      line("and {} more with smaller errors", all - shown.size());
    }
  }

  std::vector<std::size_t> constraints_shown() const {
    std::vector<std::size_t> shown(findings_.constraints.size());
    std::iota(shown.begin(), shown.end(), std::size_t{0});
    if (shown.size() > most_constraints) {
      std::stable_sort(shown.begin(), shown.end(), [this](std::size_t a, std::size_t b) { return size(a) > size(b); });
      shown.resize(most_constraints);
      std::sort(shown.begin(), shown.end());
    }
    return shown;
  }

  /// By which constraints are compared: the error of the equation itself. NaN is the largest.
  double size(std::size_t i) const {
    const LargestErrors& largest = findings_.constraints[i];
    const double size = model_.constraints[i].holonomic ? largest.position : largest.velocity;
    return std::isnan(size) ? std::numeric_limits<double>::infinity() : size;
  }

  static std::string error(double largest) { return largest == 0 ? "0" : fmt::format("{:.6e}", largest); }

  void rank_events() {
    const std::size_t shown = std::min(most_lines, findings_.rank_events.size());
    for (const RankEvent& event : std::span(findings_.rank_events).first(shown)) {
      const auto constraints = model_.islands[event.island].constraints;
      line("rank {} of {} from t = {:.9g}: {}", event.rank, constraints.size(), event.time,
           names_of(model_, constraints));
    }
    if (const long rest = findings_.rank_changes - static_cast<long>(shown); rest > 0) {
      line("and {} of rank", counted(rest, "more change"));
    }
  }

  /// The islands that were not always solved the plain way: Note [rank ladder].
  void ladder_counts() {
    std::vector<std::size_t> climbing;
    for (std::size_t k = 0; k < outcome_.solves.size(); ++k) {
      if (outcome_.solves[k].refined + outcome_.solves[k].pinv > 0) {
        climbing.push_back(k);
      }
    }
    const std::size_t shown = std::min(most_lines, climbing.size());
    for (const std::size_t k : std::span(climbing).first(shown)) {
      line("{} of {}: {} refined, {} by the pseudo-inverse", counted(outcome_.evaluations, "solve"),
           names_of(model_, model_.islands[k].constraints), outcome_.solves[k].refined, outcome_.solves[k].pinv);
    }
    if (const std::size_t rest = climbing.size() - shown; rest > 0) {
      line("and {} solved so", counted(static_cast<long>(rest), "more island"));
    }
  }

  const Description& model_;
  const Options& options_;
  const Outcome& outcome_;
  const Findings& findings_;
  std::string text_;
};

}  // namespace

std::string report(const Description& model, const Options& options, const Outcome& outcome) {
  return Report(model, options, outcome).write();
}

}  // namespace mbrt
