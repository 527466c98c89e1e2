// Emitted code and the interpreter against the equation of motion in quadruple precision, at random states of random
// scenes: with redundant rows, nearly dependent ones, and rows of every size.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

#include "driver/interpreted_model.hpp"
#include "exact.hpp"
#include "support/compiled.hpp"
#include "support/emitted_models.hpp"
#include "support/model_states.hpp"
#include "support/random_scene.hpp"

namespace mbcc::test {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr std::size_t states_per_scene = 25;
constexpr double largest_condition = 1e7;

std::optional<Compilation> accepted(const std::string& text) {
  Compilation compilation = compile("scene.mbd", text, {});
  return compilation.diagnostics.has_errors() ? std::nullopt : std::optional(std::move(compilation));
}

struct Scene {
  std::string text, rewritten;
  Compilation compilation;
  Question question;
};

/// States around the start, at which the constraints do not hold.
Question states_around_start(const Compilation& compilation, Random& random) {
  Question question;
  for (std::size_t i = 0; i < states_per_scene; ++i) {
    std::vector<double> state = start_state(compilation);
    for (double& value : state) {
      value += random.uniform(-0.5, 0.5);
    }
    question.times.push_back(random.uniform(0, 2));
    question.states.push_back(state);
  }
  return question;
}

/// As many scenes as asked for that mbcc accepts; it refuses those that ask for more than there is to move.
std::vector<Scene> draw_scenes(std::size_t count, Random& random) {
  std::vector<Scene> scenes;
  std::size_t refused = 0;
  while (scenes.size() < count) {
    const RandomScene scene(random);
    const std::string text = scene.text();
    if (auto compilation = accepted(text)) {
      Question question = states_around_start(*compilation, random);
      scenes.push_back({text, scene.rewritten(random), std::move(*compilation), std::move(question)});
    } else {
      ++refused;
    }
  }
  CHECK(refused < scenes.size());
  return scenes;
}

Answers interpret(const Compilation& c, const Question& question) {
  InterpretedModel model(*c.program, *c.system, c.sources);
  start(model);
  Answers answers;
  for (std::size_t i = 0; i < question.states.size(); ++i) {
    answers.push_back(everything_at(model, question.times[i], question.states[i]));
  }
  return answers;
}

/// What the judgement of many states comes to.
struct Tally {
  long judged = 0, ambiguous = 0, beyond_condition = 0;
  long ill_conditioned = 0, deficient = 0;  ///< of those judged
  long above_plain_bound = 0;               ///< 100 eps cond |u'|, without regard for cancellation in the rows
  double largest = 0;                       ///< error, relative to the bound

  void print(const char* what) const {
    std::printf(
        "%s: %ld islands judged (%ld with condition above 1e4, %ld rank deficient), largest error %.2g of its "
        "bound, %ld above 100 eps cond |u'|; left out: %ld near the cut-off, %ld beyond a condition of 1e7\n",
        what, judged, ill_conditioned, deficient, largest, above_plain_bound, ambiguous, beyond_condition);
  }
};

/// Rows that are held combine others with coefficients up to 10, so that the singular values of the rest are smaller by
/// no more than this; and what the rest cannot reach is no more than what all rows cannot. Without held rows least
/// squares has to weigh contradictory rows by their scales, exactly.
double weight_of_contradiction(const Compilation& c) {
  std::size_t held = 0;
  for (const mechanics::Island& island : c.derivatives.islands) {
    held += island.held.size();
  }
  return held == 0 ? 0 : std::sqrt(1 + 100 * static_cast<double>(held));
}

void judge(const std::vector<ExactIsland>& islands, const std::vector<double>& rate, double contradiction_weight,
           Tally& tally) {
  for (const ExactIsland& island : islands) {
    if (island.is_ambiguous || island.condition > largest_condition) {
      ++(island.is_ambiguous ? tally.ambiguous : tally.beyond_condition);
      continue;
    }
    const double error = distance(island, rate);
    const double leeway = island.truncation + contradiction_weight * island.contradiction;
    // 100 eps cond is what a solve may lose of what it adds up; rounding is the rows', and another order of the same
    // terms may double it.
    const double bound = 100 * eps * island.condition * island.parts + 2 * island.rounding + leeway;
    ++tally.judged;
    tally.ill_conditioned += island.condition > 1e4 ? 1 : 0;
    tally.deficient += island.is_deficient ? 1 : 0;
    tally.above_plain_bound += error > 100 * eps * island.condition * island.size + leeway ? 1 : 0;
    tally.largest = std::max(tally.largest, error / bound);
    CAPTURE(island.condition, island.size, island.parts, island.rounding, leeway);
    CHECK(error <= bound);
  }
}

/// `values` (coordinates or their rates, then speeds or theirs) of one model in the order of another with the same
/// names.
std::vector<double> reordered(const std::vector<double>& values, const model::System& from, const model::System& to) {
  std::vector<double> result;
  const auto collect = [&](const auto& names, const auto& source, std::size_t offset) {
    for (const auto& item : names) {
      const auto found =
          std::find_if(source.begin(), source.end(), [&](const auto& other) { return other.name == item.name; });
      result.push_back(values[offset + static_cast<std::size_t>(found - source.begin())]);
    }
  };
  collect(to.coordinates, from.coordinates, 0);
  collect(to.speeds, from.speeds, from.coordinates.size());
  return result;
}

}  // namespace

TEST_CASE("accelerations are those of the equation in quadruple precision") {
  Random random(20040601);
  const std::vector<Scene> scenes = draw_scenes(MBCC_ORACLE_SCENES, random);
  EmittedModels emitted;
  std::vector<Question> questions;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    const Compilation& c = scenes[i].compilation;
    const Compilation named = compile("scene_" + std::to_string(i) + ".mbd", scenes[i].text, {});
    emitted.add("scene_" + std::to_string(i), emit(*named.program, *c.system, named.sources, {true, false}));
    questions.push_back(scenes[i].question);
  }
  const Outcome built = emitted.build({"-O1"});
  INFO(built.errors);
  REQUIRE(built.exit_code == 0);
  const std::vector<Answers> answers = emitted.ask(questions);

  Tally of_emitted, of_interpreter;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    INFO(scenes[i].text);
    const ExactModel exact(scenes[i].compilation);
    const Answers interpreted = interpret(scenes[i].compilation, scenes[i].question);
    const double weight = weight_of_contradiction(scenes[i].compilation);
    for (std::size_t k = 0; k < states_per_scene; ++k) {
      const std::vector<ExactIsland> islands = exact.at(scenes[i].question.times[k], scenes[i].question.states[k]);
      judge(islands, answers[i][k], weight, of_emitted);
      judge(islands, interpreted[k], weight, of_interpreter);
    }
  }
  of_emitted.print("emitted");
  of_interpreter.print("interpreted");
  CHECK(of_emitted.ill_conditioned > of_emitted.judged / 50);
  CHECK(of_emitted.deficient > of_emitted.judged / 50);
}

TEST_CASE("neither the order of particles and constraints nor a factor on a constraint matters") {
  Random random(20040602);
  Tally tally;
  for (const Scene& scene : draw_scenes(MBCC_ORACLE_SCENES, random)) {
    INFO(scene.text);
    INFO(scene.rewritten);
    const std::optional<Compilation> other = accepted(scene.rewritten);
    REQUIRE(other);
    Question question = scene.question;
    for (std::vector<double>& state : question.states) {
      state = reordered(state, *scene.compilation.system, *other->system);
    }
    const Answers rates = interpret(*other, question);
    const ExactModel exact(scene.compilation);
    for (std::size_t k = 0; k < states_per_scene; ++k) {
      judge(exact.at(question.times[k], scene.question.states[k]),
            reordered(rates[k], *other->system, *scene.compilation.system), weight_of_contradiction(*other), tally);
    }
  }
  tally.print("reordered and rescaled");
}

}  // namespace mbcc::test
