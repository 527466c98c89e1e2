// The pages of docs/ that are made: they are current, and what they show is right.

#include <catch2/catch.hpp>
#include <regex>

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
  CHECK(models == 9);
}

TEST_CASE("the gallery shows every example, and the figures are there") {
  const std::string page = read_file(root / "docs/gallery.md");
  for (const auto& example : std::filesystem::directory_iterator(root / "examples")) {
    if (example.is_directory()) {
      const std::string name = example.path().filename().string();
      INFO(name);
      CHECK(page.find("](../examples/" + name + ")\n") != std::string::npos);
      CHECK(page.find("](gallery/" + name + ".svg)\n") != std::string::npos);
      CHECK(std::filesystem::exists(root / "docs/gallery" / (name + ".svg")));
    }
  }
}

TEST_CASE("links between pages lead somewhere") {
  std::vector<std::filesystem::path> pages = {root / "README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") {
      pages.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& page : pages) {
    const std::string text = read_file(page);
    const std::regex link("\\]\\(([^)#]+)[^)]*\\)");
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
      const std::string target = (*at)[1];
      INFO(page.filename() << " links " << target);
      CHECK((target.rfind("http", 0) == 0 || std::filesystem::exists(page.parent_path() / target)));
    }
  }
}

}  // namespace mbcc::test
