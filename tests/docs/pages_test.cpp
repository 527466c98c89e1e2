// The pages of docs/ that are made: they are current, and what they show is right.

#include <catch2/catch.hpp>

#include "support/markdown.hpp"
#include "support/run_model.hpp"

namespace mbcc::test {
namespace {

const std::filesystem::path root = MBCC_SOURCE_DIR;

}  // namespace

TEST_CASE("the page on the language is what `make docs` makes of the table and the grammar") {
  const Outcome made = run_program(
      LANGUAGE_REFERENCE, {(root / "docs/reference/language.md.in").string(), (root / "grammar/model.ebnf").string()});
  CHECK(made.errors.empty());
  CHECK(made.output == read_file(root / "docs/language.md"));
}

TEST_CASE("a production that the page on the language does not show is missed") {
  const ScratchDirectory scratch;
  write_file(scratch / "model.ebnf", read_file(root / "grammar/model.ebnf") + "\nnovelty = \"new\".\n");
  const std::string page = (root / "docs/reference/language.md.in").string();
  const Outcome outcome = run_program(LANGUAGE_REFERENCE, {page, scratch / "model.ebnf"});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.errors == page + ": there is no place for `novelty`\n");
}

TEST_CASE("every model on the page on the language is one, without a warning") {
  const ScratchDirectory scratch;
  int models = 0;
  for (const Block& block : blocks_of(root / "docs/language.md")) {
    if (block.language == "mbd") {
      ++models;
      write_file(scratch / "model.mbd", block.text);
      const Outcome outcome = run_mbcc({"check", scratch / "model.mbd", "--werror"});
      INFO(block.text << outcome.errors);
      CHECK(outcome.exit_code == 0);
    }
  }
  CHECK(models == 4);
}

}  // namespace mbcc::test
