// The derivatives that emitted code computes against differences of its rates, and against the interpreter's.

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "driver/interpreted_model.hpp"
#include "emitted_case.hpp"
#include "support/model_states.hpp"
#include "support/random_scene.hpp"

namespace mbcc::test {
namespace {

/// How far a component is moved, in steps, for a difference of order 4, and what the rates there count.
constexpr double step = 1e-5;
constexpr std::array offsets = {-2.0, -1.0, 1.0, 2.0};
constexpr std::array weights = {1.0 / 12, -8.0 / 12, 8.0 / 12, -1.0 / 12};

/// The question is of a state a little off the start, then of it moved along each component.
Case make_case(const std::string& name, const std::string& path, std::string text, Random& random) {
  Case result{name, compile(path, std::move(text), {false, Stage::Program, false, "radau"}), {}};
  if (result.compilation.diagnostics.has_errors()) {
    return result;
  }
  std::vector<double> state = start_state(result.compilation);
  for (double& value : state) {
    value += random.uniform(-1e-2, 1e-2);
  }
  result.question.states.push_back(state);
  for (std::size_t j = 0; j < state.size(); ++j) {
    for (const double offset : offsets) {
      result.question.states.push_back(state);
      result.question.states.back()[j] += offset * step;
    }
  }
  result.question.times.assign(result.question.states.size(), random.uniform(0, 1));
  return result;
}

/// The answers' Jacobian; empty if the model has none at the state.
std::vector<double> jacobian_in(const std::vector<double>& answer, std::size_t answer_without, std::size_t size) {
  const bool has_one = answer.size() == answer_without + size * size;
  return has_one ? std::vector<double>(answer.end() - static_cast<std::ptrdiff_t>(size * size), answer.end())
                 : std::vector<double>();
}

/// All that is answered besides a Jacobian: rates, errors of constraints, outputs, energy, forces.
std::size_t answers_without_jacobian(const Case& c) {
  const model::System& system = *c.compilation.system;
  return system.coordinates.size() + system.speeds.size() + 3 * system.constraints.size() + system.outputs.size() +
         (c.compilation.derivatives.energy ? 1 : 0) + system.forces.size();
}

/// Whether the Jacobian was there to be compared.
bool is_checked(const Case& c, const Answers& answers) {
  const std::size_t size = c.question.states.front().size();
  const std::vector<double> columns = jacobian_in(answers.front(), answers_without_jacobian(c), size);
  if (columns.empty()) {
    return false;
  }
  for (std::size_t j = 0; j < size; ++j) {
    double largest = 0, rate = 0, difference = 0;
    for (std::size_t i = 0; i < size; ++i) {
      double quotient = 0;
      for (std::size_t n = 0; n < offsets.size(); ++n) {
        quotient += weights[n] / step * answers[1 + offsets.size() * j + n][i];
      }
      largest = std::max(largest, std::abs(quotient));
      rate = std::max(rate, std::abs(answers.front()[i]));
      difference = std::max(difference, std::abs(quotient - columns[j * size + i]));
    }
    INFO(c.name << ", column " << j);
    // Derivatives are known to 1e-6 where pivots are down to 1e-9 of what they started from, rates to 1e-10 on the
    // steps of the ladder below the first.
    CHECK(difference <= 1e-6 * largest + 1e-10 / step * rate);
  }
  return true;
}

/// Builds all cases into one program and compares; returns the names of those that have no Jacobian.
std::vector<std::string> compare(const std::vector<Case>& cases) {
  const std::vector<Answers> answers = answers_of(cases);
  std::vector<std::string> refused;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    if (!is_checked(cases[c], answers[c])) {
      refused.push_back(cases[c].name);
    }
    InterpretedModel interpreter(*cases[c].compilation.program, *cases[c].compilation.system,
                                 cases[c].compilation.sources);
    start(interpreter);
    INFO(cases[c].name);
    CHECK(everything_at(interpreter, cases[c].question.times[0], cases[c].question.states[0]) == answers[c][0]);
  }
  std::sort(refused.begin(), refused.end());
  return refused;
}

}  // namespace

TEST_CASE("emitted Jacobians of the published models are those of their rates") {
  std::vector<Case> cases;
  Random random(20100808);
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models")) {
    const std::string name = file.path().stem();
    // Those are other models for a shorter time.
    const bool is_other_run = name.ends_with("_t1") || name.ends_with("_t10") || name.ends_with("_presingular");
    if (file.path().extension() == ".mbd" && !is_other_run) {
      cases.push_back(make_case(name, file.path(), read_file(file.path()), random));
    }
  }
  // Bricard's mechanism has one too, off its constraints, where no row depends on the others.
  CHECK(compare(cases).empty());
}

TEST_CASE("emitted Jacobians of random scenes are those of their rates") {
  Random random(20101010);
  std::vector<Case> cases;
  while (cases.size() < 20) {
    const std::string name = "scene_" + std::to_string(cases.size());
    Case drawn = make_case(name, name + ".mbd", RandomScene(random).text(), random);
    if (!drawn.compilation.diagnostics.has_errors()) {
      cases.push_back(std::move(drawn));
    }
  }
  CHECK(compare(cases).size() < 10);  // redundant rows on purpose in a third of them
}

}  // namespace mbcc::test
