// Diagnostics as people and programs see them.

#include "diagnostics/render.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace mbcc {
namespace {

/// A model text with one diagnostic about a part of it.
std::string rendered(std::string text, std::uint32_t begin, std::uint32_t end) {
  Sources sources;
  sources.add("model.mbd", std::move(text));
  Diagnostics diagnostics;
  diagnostics.report(Finding::UnmatchedBrace, {0, begin, end});
  return render(diagnostics, sources);
}

}  // namespace

TEST_CASE("the caret stands under the span") {
  CHECK(rendered("let a = bob.x\n", 8, 13) ==
        "model.mbd:1:9: error: `}` closes nothing\n"
        "let a = bob.x\n"
        "        ^~~~~\n");
}

TEST_CASE("an empty span and the end of the text have a caret too") {
  CHECK(rendered("ab", 1, 1) == "model.mbd:1:2: error: `}` closes nothing\nab\n ^\n");
  CHECK(rendered("ab\n", 3, 3) == "model.mbd:2:1: error: `}` closes nothing\n\n^\n");
  CHECK(rendered("", 0, 0) == "model.mbd:1:1: error: `}` closes nothing\n\n^\n");
}

TEST_CASE("a span over several lines is underlined to the end of its first") {
  CHECK(rendered("a = (1,\n2)\n", 4, 10) == "model.mbd:1:5: error: `}` closes nothing\na = (1,\n    ^~~\n");
}

TEST_CASE("the caret stands right behind tabs") {
  CHECK(rendered("\tab\tcd", 4, 6) ==
        "model.mbd:1:5: error: `}` closes nothing\n        ab      cd\n                ^~\n");
  CHECK(rendered("a\tb", 0, 3) == "model.mbd:1:1: error: `}` closes nothing\na       b\n^~~~~~~~~\n");
}

TEST_CASE("the caret counts characters where the column counts bytes") {
  CHECK(rendered("# \u00E9\u221A b", 8, 9) == "model.mbd:1:9: error: `}` closes nothing\n# \u00E9\u221A b\n     ^\n");
}

TEST_CASE("of a very long line the part around the caret is shown") {
  const std::string a(1000, 'a'), b(1000, 'b');
  const std::string a100(100, 'a'), b149(149, 'b');
  CHECK(rendered(a + "X" + b, 1000, 1001) == "model.mbd:1:1001: error: `}` closes nothing\n..." + a100 + "X" + b149 +
                                                 "...\n" + std::string(103, ' ') + "^\n");
  CHECK(rendered("X" + b, 0, 1001) ==
        "model.mbd:1:1: error: `}` closes nothing\nX" + b149 + "...\n^" + std::string(152, '~') + "\n");
  CHECK(rendered(a + "X", 1000, 1001) ==
        "model.mbd:1:1001: error: `}` closes nothing\n..." + a100 + "X\n" + std::string(103, ' ') + "^\n");
}

TEST_CASE("control characters do not reach the terminal") {
  CHECK(rendered("a\x1B[1mb\r\n", 6, 7) == "model.mbd:1:7: error: `}` closes nothing\na [1mb\n      ^\n");
}

TEST_CASE("notes follow their diagnostic, and diagnostics the text") {
  Sources sources;
  sources.add("a.mbd", "let a = 1\nlet a = 2\n");
  sources.add("b.mbd", "let b = 1\n");
  Diagnostics diagnostics;
  diagnostics.report(Finding::UnmatchedBrace, {1, 4, 5});
  diagnostics.report(Finding::PowerOfPower, {0, 14, 15}, "a^b^c", "(a^b)^c").note({0, 4, 5}, "see here");
  diagnostics.report(Finding::UnmatchedBrace, {0, 0, 3});
  CHECK(render(diagnostics, sources) == R"(a.mbd:1:1: error: `}` closes nothing
let a = 1
^~~
a.mbd:2:5: warning: `a^b^c` is read as `(a^b)^c`: parentheses would make it clear
let a = 2
    ^
a.mbd:1:5: note: see here
let a = 1
    ^
b.mbd:1:5: error: `}` closes nothing
let b = 1
    ^
)");
}

TEST_CASE("colours are used when asked for") {
  Sources sources;
  sources.add("a.mbd", "}");
  Diagnostics diagnostics;
  diagnostics.report(Finding::UnmatchedBrace, {0, 0, 1});
  CHECK(render(diagnostics, sources, Colours::On) ==
        "\033[1ma.mbd:1:1:\033[0m \033[1;31merror:\033[0m `}` closes nothing\n}\n\033[1;32m^\033[0m\n");
}

TEST_CASE("JSON has the same as data") {
  Sources sources;
  sources.add("a.mbd", "let a = 1\nlet a\n = 2\n");
  Diagnostics diagnostics;
  diagnostics.report(Finding::PowerOfPower, {0, 14, 20}, "a^b^c", "(a^b)^c").note({0, 4, 5}, "see here");
  CHECK(nlohmann::json::parse(render_json(diagnostics, sources)) == nlohmann::json::parse(R"([
    {"severity": "warning", "name": "PowerOfPower", "file": "a.mbd", "line": 2, "column": 5, "end_line": 3,
     "end_column": 5, "message": "`a^b^c` is read as `(a^b)^c`: parentheses would make it clear",
     "notes": [{"file": "a.mbd", "line": 1, "column": 5, "end_line": 1, "end_column": 6, "message": "see here"}]}
  ])"));
  CHECK(render_json(Diagnostics(), sources) == "[]");
}

TEST_CASE("JSON survives text that is not UTF-8") {
  Sources sources;
  sources.add("\xFF.mbd", "\xFE");
  Diagnostics diagnostics;
  diagnostics.report(Finding::UnknownSign, {0, 0, 1}, "\xFE");
  const auto json = nlohmann::json::parse(render_json(diagnostics, sources));
  CHECK(json[0]["file"] == "\uFFFD.mbd");
  CHECK(json[0]["message"] == "`\uFFFD` has no meaning in a model");
}

}  // namespace mbcc
