#pragma once
// Compiled models whose emitted code is asked, all built into one program.

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "support/compiled.hpp"
#include "support/emitted_models.hpp"

namespace mbcc::test {

struct Case {
  std::string name;
  Compilation compilation;
  Question question;
};

/// What each case's emitted class answers; it compiles without warnings.
inline std::vector<Answers> answers_of(const std::vector<Case>& cases) {
  EmittedModels emitted;
  std::vector<Question> questions;
  for (const Case& c : cases) {
    emitted.add(c.name, emit(*c.compilation.program, *c.compilation.system, c.compilation.sources, {true, false}));
    questions.push_back(c.question);
  }
  const Outcome built = emitted.build({"-O0", "-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror"});
  INFO(built.errors);
  REQUIRE(built.exit_code == 0);
  return emitted.ask(questions);
}

}  // namespace mbcc::test
