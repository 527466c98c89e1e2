// Large scenes, whose repeated parts are loops: the emitted code computes, bit for bit, what the interpreter computes,
// which knows of no loops. (Without contraction both do the same operations in the same order.)

#include <catch2/catch.hpp>

#include "driver/interpreted_model.hpp"
#include "support/compiled.hpp"
#include "support/emitted_models.hpp"
#include "support/model_states.hpp"
#include "support/random.hpp"
#include "support/scenes.hpp"

namespace mbcc::test {

TEST_CASE("loops compute what straight lines would") {
  const std::vector<std::string> texts = {chain(17), chain(60), wheel(40), net(7), cluster(20), springs(40)};
  Random random(1);
  EmittedModels models;
  std::vector<Question> questions;
  std::vector<Answers> expected;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string name = "scene_" + std::to_string(i);
    const Compilation c = compile(name + ".mbd", texts[i], {});
    INFO(messages_of(c));
    REQUIRE(c.program);
    const std::string text = emit(*c.program, *c.system, c.sources, {true, false});
    CHECK(has_rolled_loops(text));
    models.add(name, text);
    InterpretedModel interpreter(*c.program, *c.system, c.sources);
    const std::vector<double> at_start = start(interpreter);
    questions.emplace_back();
    expected.emplace_back();
    for (int k = 0; k < 5; ++k) {
      std::vector<double> state = at_start;
      for (double& value : state) {
        value += random.uniform(-0.1, 0.1);
      }
      questions.back().times.push_back(0.1 * k);
      questions.back().states.push_back(state);
      expected.back().push_back(everything_at(interpreter, 0.1 * k, state));
    }
  }
  const Outcome built = models.build({"-O1", "-ffp-contract=off", "-fno-builtin", "-Wall", "-Wextra", "-Wpedantic",
                                      "-Wshadow", "-Wconversion", "-Wsign-conversion", "-Werror"});
  INFO(built.errors);
  REQUIRE(built.exit_code == 0);
  const std::vector<Answers> answers = models.ask(questions);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    INFO(texts[i]);
    CHECK(answers[i] == expected[i]);
  }
}

}  // namespace mbcc::test
