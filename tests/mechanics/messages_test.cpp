// Every finding about the physics of a model, whole: bad/*.mbd and what mbcc says about them, in bad/transcript.txt.
// After a wanted change of wording, MBCC_ACCEPT=1 in the environment writes the transcript anew.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "support/compiled.hpp"
#include "support/run_program.hpp"

namespace mbcc::test {
namespace {

const std::filesystem::path folder = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/mechanics/bad";

std::map<std::string, Compilation> all_bad() {
  std::map<std::string, Compilation> all;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".mbd") {
      const std::string name = entry.path().filename().string();
      all.emplace(name, compile(name, read_file(entry.path()), {}));
    }
  }
  return all;
}

}  // namespace

TEST_CASE("messages about physics are those of the transcript") {
  std::string transcript;
  for (const auto& [name, compilation] : all_bad()) {
    transcript += "== " + name + "\n" + messages_of(compilation);
  }
  if (std::getenv("MBCC_ACCEPT") != nullptr) {
    write_file(folder / "transcript.txt", transcript);
  }
  CHECK(transcript == read_file(folder / "transcript.txt"));
}

TEST_CASE("every finding about physics is in the transcript") {
  std::set<Finding> seen;
  for (const auto& [name, compilation] : all_bad()) {
    CHECK(compilation.program.has_value() == !compilation.diagnostics.has_errors());
    for (const Diagnostic& diagnostic : compilation.diagnostics.all()) {
      seen.insert(diagnostic.finding);
    }
  }
  for (int row = static_cast<int>(Finding::RedundantConstraint); row <= static_cast<int>(Finding::NotFiniteAtStart);
       ++row) {
    INFO(name_of(static_cast<Finding>(row)));
    CHECK(seen.contains(static_cast<Finding>(row)));
  }
}

TEST_CASE("a start typed with seven digits passes, one with a wrong digit does not") {
  const auto findings = [](const std::string& x) {
    return compile("model.mbd",
                   "dimension 2\nparticle 1 { mass = 1; position = (" + x + ", " + x +
                       ") }\nconstraint : x1^2 + y1^2 = 1\n",
                   {})
        .diagnostics.all()
        .size();
  };
  CHECK(findings("0.7071068") == 0);
  CHECK(findings("0.7071168") == 1);
}

}  // namespace mbcc::test
