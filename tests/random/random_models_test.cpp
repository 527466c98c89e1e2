// Random models end to end: whatever mbcc accepts has to compile without a warning, and to compute what the interpreter
// computes.

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <mbrt/rk4.hpp>
#include <memory>

#include "driver/interpreted_model.hpp"
#include "random_model.hpp"
#include "support/compiled.hpp"
#include "support/emitted_models.hpp"
#include "support/model_states.hpp"

namespace mbcc::test {
namespace {

const std::vector<std::string> warnings = {
    "-Wall",        "-Wextra",           "-Wpedantic",         "-Wshadow",
    "-Wconversion", "-Wsign-conversion", "-Wdouble-promotion", "-Wold-style-cast",
    "-Wcast-qual",  "-Wunused",          "-Wfloat-conversion", "-Werror"};

struct Accepted {
  std::string name;
  Compilation compilation;
  Question question;
  Answers interpreted;
};

/// The states of a few steps from the start.
struct Visited {
  Question& question;
  void arriving() {}
  bool accepted(double time, const std::vector<double>& state, const std::vector<double>&) {
    question.times.push_back(time);
    question.states.push_back(state);
    return true;
  }
};

void interpret(Accepted& model) {
  InterpretedModel interpreter(*model.compilation.program, *model.compilation.system, model.compilation.sources);
  std::vector<double> state = start(interpreter);
  Visited visited{model.question};
  mbrt::rk4(interpreter, state, {0, 0.05, 0.01, 5}, visited);
  for (std::size_t i = 0; i < model.question.states.size(); ++i) {
    model.interpreted.push_back(everything_at(interpreter, model.question.times[i], model.question.states[i]));
  }
}

std::vector<Accepted> draw_models(std::size_t count, Random& random) {
  std::vector<Accepted> models;
  std::size_t refused = 0;
  while (models.size() < count) {
    const std::string name = "model_" + std::to_string(models.size());
    Compilation compilation = compile(name + ".mbd", RandomModel(random).text(), {});
    if (compilation.diagnostics.has_errors()) {
      ++refused;
      continue;
    }
    models.push_back({name, std::move(compilation), {}, {}});
    interpret(models.back());
  }
  std::printf("%zu random models accepted, %zu refused\n", count, refused);
  CHECK(refused < count);
  return models;
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

}  // namespace

TEST_CASE("random models compile without a warning and compute what the interpreter computes") {
  Random random(20250101);
  const std::vector<Accepted> models = draw_models(MBCC_RANDOM_MODELS, random);
  EmittedModels emitted;
  std::vector<Question> questions;
  std::size_t rolled = 0;
  for (const Accepted& model : models) {
    const Compilation& c = model.compilation;
    const std::string text = emit(*c.program, *c.system, c.sources, {true, false});
    rolled += static_cast<std::size_t>(has_rolled_loops(text));
    emitted.add(model.name, text);
    questions.push_back(model.question);
  }
  CHECK(rolled > models.size() / 50);
  // Both sides are to call the same functions with the same numbers: a C++ compiler that knows a parameter's default
  // would evaluate exp(parameter) itself, and may round it better than the library does.
  std::vector<std::string> flags = warnings;
  flags.insert(flags.end(), {"-O1", "-ffp-contract=off", "-fno-builtin"});
  const Outcome built = emitted.build(flags);
  INFO(built.errors);
  REQUIRE(built.exit_code == 0);
  if (std::filesystem::exists("/usr/bin/clang++")) {
    const Outcome checked = emitted.check("/usr/bin/clang++", warnings);
    INFO(checked.errors);
    CHECK(checked.exit_code == 0);
  }

  const std::vector<Answers> answers = emitted.ask(questions);
  std::size_t numbers = 0, finite = 0;
  for (std::size_t i = 0; i < models.size(); ++i) {
    INFO(models[i].compilation.sources[0].text());
    REQUIRE(answers[i].size() == models[i].interpreted.size());
    for (std::size_t k = 0; k < answers[i].size(); ++k) {
      REQUIRE(answers[i][k].size() == models[i].interpreted[k].size());
      for (std::size_t n = 0; n < answers[i][k].size(); ++n) {
        CAPTURE(i, k, n, answers[i][k][n], models[i].interpreted[k][n]);
        REQUIRE(same(answers[i][k][n], models[i].interpreted[k][n]));
        ++numbers;
        finite += static_cast<std::size_t>(std::isfinite(answers[i][k][n]));
      }
    }
  }
  std::printf("%zu numbers compared, %zu of them finite\n", numbers, finite);
  CHECK(finite > numbers / 10 * 9);  // or they would compare little
}

}  // namespace mbcc::test
