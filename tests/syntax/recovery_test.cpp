// After a mistake the parser goes on where the next statement or field begins, and says nothing that follows from it.

#include <catch2/catch.hpp>

#include "syntax/front_end.hpp"

namespace mbcc {
namespace {

/// Lines in which something was found, in the order of the text.
std::vector<std::uint32_t> lines_found(const FrontEnd& front_end) {
  std::vector<std::uint32_t> lines;
  for (const Diagnostic& diagnostic : front_end.diagnostics.all()) {
    lines.push_back(front_end.sources.position(diagnostic.span).line);
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

using Lines = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("each bad statement is reported and the good ones are kept") {
  const FrontEnd front_end(R"(let a = 1
let b =
let c = 3 +* 4
let d = 4
system 1; system 2; let e = 5
partcle 3 { mass = ( }
let f = 6)");
  CHECK(lines_found(front_end) == Lines{2, 3, 5, 5, 6});
  CHECK(print(front_end.model) == "let a = 1\nlet d = 4\nlet e = 5\nlet f = 6\n");
}

TEST_CASE("each bad field is reported and the good ones are kept") {
  const FrontEnd front_end(R"(particle 1 {
  mass 1
  7 = 8
  position = (1, 2
  velocity = (1, 2, 3)
  force = 3 4
}
let a = 1)");
  // The bracket of line 4 stays open through line 5, where the error is.
  CHECK(lines_found(front_end) == Lines{2, 3, 5, 6});
  CHECK(print(front_end.model) == "particle 1\n  force = 3\nlet a = 1\n");
}

TEST_CASE("mistakes inside loops do not end the loop") {
  const FrontEnd front_end(R"(for i in 1..3 {
  let a = *
  for j in 1..3 {
    let b = )
    let c = 1
  }
  let d = 2
}
let e = 3)");
  CHECK(lines_found(front_end) == Lines{2, 4});
  CHECK(print(front_end.model) == "for i in 1 .. 3\n  for j in 1 .. 3\n    let c = 1\n  let d = 2\nlet e = 3\n");
}

TEST_CASE("a bracket that is never closed swallows one statement") {
  const FrontEnd front_end("let a = (1 +\nlet b = 2\nlet c = [3\nparticle 1 { mass = (1 }\nlet d = 4");
  CHECK(lines_found(front_end) == Lines{1, 3, 4});
  CHECK(print(front_end.model) == "let b = 2\nparticle 1\nlet d = 4\n");
}

TEST_CASE("a block that is never closed ends before the next statement") {
  const FrontEnd front_end("particle 1 {\n  mass = 1\nparticle 2 {\n  mass = 2\n}\nlet a = 1");
  CHECK(lines_found(front_end) == Lines{3});
  CHECK(print(front_end.model) == "particle 2\n  mass = 2\nlet a = 1\n");
}

TEST_CASE("loops that are never closed are one mistake") {
  const FrontEnd front_end("for i in 1..2 {\nfor j in 1..2 {\nlet a = 1");
  CHECK(lines_found(front_end) == Lines{3});
}

TEST_CASE("what the lexer refused is not reported again by the parser") {
  const FrontEnd front_end("let a = 3 @ 4\nlet b = @\nlet c = 2 $\n@ let d = 1\nimport \"x\nlet e = 1 1");
  CHECK(lines_found(front_end) == Lines{1, 2, 3, 4, 5, 6});
}

TEST_CASE("a brace too many is one mistake") {
  const FrontEnd front_end("}\nlet a = 1\n}}\nlet b = 2");
  CHECK(lines_found(front_end) == Lines{1, 3, 3});
  CHECK(print(front_end.model) == "let a = 1\nlet b = 2\n");
}

}  // namespace mbcc
