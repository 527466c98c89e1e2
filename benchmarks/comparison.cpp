#include "comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "emitted/emitted.hpp"
#include "expert/expert.hpp"
#include "generic/generic.hpp"

namespace bench {

namespace {

/// The contenders use one method with one step, so that their states differ by rounding, which these motions do not
/// raise above 1e-11. A wrong term shows in the first digits.
constexpr double rounding = 1e-9;

/// A contender that cannot finish the scene in this time is compared with the others over fewer steps.
constexpr double patience = 1.0;

std::vector<Subject> subjects_of(const Scene& scene) {
  std::vector<Subject> subjects;
  if (auto program = emitted::find(scene.model)) {
    if (program->start != scene.start) {
      throw std::logic_error(scene.model + ".mbd does not start where its scene does");
    }
    subjects.push_back({scene, program->contender});
  }
  subjects.push_back({scene, expert::contender(scene.model)});
  if (auto generic = generic::contender(scene.model)) {
    subjects.push_back({scene, *generic});
  }
  return subjects;
}

/// NaN if any difference is.
double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    const double difference = std::abs(a[j] - b[j]);
    largest = difference <= largest ? largest : difference;
  }
  return largest;
}

double end_error(const Scene& scene, const std::vector<double>& state) {
  double largest = 0;
  for (const Known& known : scene.end) {
    largest = std::max(largest, std::abs(state[known.component] - known.value));
  }
  return largest;
}

Result judge(const Subject& subject, const Subject& expert) {
  const long steps = affordable_steps(subject, patience);
  const std::vector<double> state = state_after(subject, steps);
  Result result{subject.contender.name, {}, {}, largest_difference(state, state_after(expert, steps))};
  if (steps == subject.scene.steps) {
    result.error = end_error(subject.scene, state);
  }
  return result;
}

double ratio(const Result* a, const Result* b) {
  return a != nullptr && b != nullptr ? a->timing.median / b->timing.median : std::nan("");
}

/// An absent number is a dash.
std::string number(double value, int precision) {
  return std::isnan(value) ? "-" : fmt::format("{:.{}f}", value, precision);
}

void print_row(const Comparison& comparison) {
  std::string line = fmt::format("{:<10}", comparison.scene.model);
  for (const char* name : {"emitted", "expert", "generic"}) {
    const Result* result = comparison.find(name);
    const std::string cell =
        result == nullptr ? "-" : fmt::format("{:.1f} ({:.1f})", result->timing.median, result->timing.minimum);
    line += fmt::format(" {:>24}", cell);
  }
  const Result* emitted = comparison.find("emitted");
  line += fmt::format(" {:>15} {:>16}", number(ratio(emitted, comparison.find("expert")), 2),
                      number(ratio(comparison.find("generic"), emitted), 0));
  fmt::print("{}\n", line);
}

void print_check(const Comparison& comparison) {
  for (const Result& result : comparison.results) {
    const std::string error = result.error ? fmt::format("{:.2e}", *result.error) : "not run to the end";
    fmt::print("{:<10} {:<8} {:>18}   {:.1e}\n", comparison.scene.model, result.contender, error, result.disagreement);
  }
}

}  // namespace

const Result* Comparison::find(std::string_view contender) const {
  const auto found = std::find_if(results.begin(), results.end(),
                                  [contender](const Result& result) { return result.contender == contender; });
  return found == results.end() ? nullptr : &*found;
}

bool Comparison::agrees() const {
  return std::all_of(results.begin(), results.end(), [this](const Result& result) {
    return result.disagreement <= rounding && (!result.error || *result.error <= scene.error_bound);
  });
}

Comparison compare(const Scene& scene, Effort effort) {
  const std::vector<Subject> subjects = subjects_of(scene);
  const auto expert = std::find_if(subjects.begin(), subjects.end(),
                                   [](const Subject& subject) { return subject.contender.name == "expert"; });
  Comparison comparison{scene, {}};
  for (const Subject& subject : subjects) {
    comparison.results.push_back(judge(subject, *expert));
  }
  const std::vector<Timing> timings = measure(subjects, effort);
  for (std::size_t k = 0; k < timings.size(); ++k) {
    comparison.results[k].timing = timings[k];
  }
  return comparison;
}

void print(const std::vector<Comparison>& comparisons) {
  fmt::print("Nanoseconds per right-hand side, RK4 included: median (minimum)\n\n");
  fmt::print("{:<10} {:>24} {:>24} {:>24} {:>15} {:>16}\n", "", "emitted", "expert", "generic", "emitted/expert",
             "generic/emitted");
  for (const Comparison& comparison : comparisons) {
    print_row(comparison);
  }
  fmt::print("\nWhat they computed: error at the end, largest difference from the expert's state\n\n");
  for (const Comparison& comparison : comparisons) {
    print_check(comparison);
  }
}

}  // namespace bench
