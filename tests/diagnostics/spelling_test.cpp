// Guesses of misspelt words.

#include "diagnostics/spelling.hpp"

#include <catch2/catch.hpp>

namespace mbcc {
namespace {

const std::vector<std::string_view> words = {"particle", "parameter", "part", "let", "for", "force", "x1"};

}  // namespace

TEST_CASE("a slip is guessed") {
  CHECK(closest("partcle", words) == "particle");    // a letter left out
  CHECK(closest("particcle", words) == "particle");  // one too many
  CHECK(closest("parameper", words) == "parameter");
  CHECK(closest("praticle", words) == "particle");  // two exchanged
  CHECK(closest("lte", words) == "let");
  CHECK(closest("y1", words) == "x1");
}

TEST_CASE("what is far from all words has no guess") {
  CHECK(closest("coordinate", words).empty());
  CHECK(closest("ab", words).empty());
  CHECK(closest("q", words).empty());
  CHECK(closest("", words).empty());
  CHECK(closest("let", {}).empty());
  CHECK(closest(std::string(10000, 'a'), {"aaa"}).empty());
}

TEST_CASE("of several near words the nearest wins, then the first") {
  CHECK(closest("fore", words) == "for");
  CHECK(closest("parts", words) == "part");
}

TEST_CASE("a suggestion is the tail of a message") {
  CHECK(suggestion("partcle", words) == "; did you mean `particle`?");
  CHECK(suggestion("coordinate", words).empty());
}

}  // namespace mbcc
