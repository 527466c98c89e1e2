// Each message about tokens and grammar, whole, as the user sees it.

#include <catch2/catch.hpp>
#include <set>

#include "syntax/front_end.hpp"

namespace mbcc {
namespace {

struct Case {
  Finding finding;
  std::string model;
  std::string message;
};

/// So many of the same text.
std::string times(std::size_t count, std::string_view text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) {
    all += text;
  }
  return all;
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {Finding::UnknownSign, "let a = 3 @ 4", R"(model.mbd:1:11: error: `@` has no meaning in a model
let a = 3 @ 4
          ^
)"},
      {Finding::UnknownSign, "let a = \x01", R"(model.mbd:1:9: error: `\x01` has no meaning in a model
let a =  
        ^
)"},
      {Finding::ForeignSign, "constraint : |x1 = 2",
       R"(model.mbd:1:14: error: `|` has no meaning in a model: write `abs(a)` for a number and `norm(a)` for a vector
constraint : |x1 = 2
             ^
)"},
      {Finding::ForeignSign, "let a = if(x1 < 1 && x1 > 0, 1, 2)",
       R"(model.mbd:1:19: error: `&&` has no meaning in a model: there is no `and`, `or` and `not`; choose with one `if` inside another
let a = if(x1 < 1 && x1 > 0, 1, 2)
                  ^~
)"},
      {Finding::ForeignSign, "let a = 3 ** 2",
       R"(model.mbd:1:11: error: `**` has no meaning in a model: a power is written `^`
let a = 3 ** 2
          ^~
)"},
      {Finding::ForeignSign, "let b = 3 − 2", R"(model.mbd:1:11: error: `−` has no meaning in a model: write a plain `-`
let b = 3 − 2
          ^
)"},
      {Finding::ForeignSign, "let a = 1  // one",
       R"(model.mbd:1:12: error: `//` has no meaning in a model: a comment begins with `#`
let a = 1  // one
           ^~
)"},
      {Finding::NotUtf8, "let a = \xFF\xFE 3",
       "model.mbd:1:9: error: the byte `\\xFF` is no character of UTF-8 text\nlet a = \xFF\xFE 3\n        ^~\n"},
      {Finding::UnterminatedText, "import \"joints.mbd",
       R"(model.mbd:1:8: error: the text that begins here has no closing `"` on its line
import "joints.mbd
       ^
)"},
      {Finding::NumberOutOfRange, "let a = 2*1e999",
       R"(model.mbd:1:11: error: `1e999` is beyond the range of double precision
let a = 2*1e999
          ^~~~~
)"},
      {Finding::Expected, "let a = (x1 + )*2", R"(model.mbd:1:15: error: expected an operand, found `)`
let a = (x1 + )*2
              ^
)"},
      {Finding::Expected, "let a = 2 x1",
       R"(model.mbd:1:11: error: expected an operator or the end of the statement, found `x1`
let a = 2 x1
          ^~
)"},
      {Finding::Expected, "system", R"(model.mbd:1:7: error: expected a name, found the end of the file
system
      ^
)"},
      {Finding::Expected, "constraint rod x1^2 = 1",
       R"(model.mbd:1:16: error: expected `:` before the equation, found `x1`
constraint rod x1^2 = 1
               ^~
)"},
      {Finding::Expected, "let a =\nlet b = 1",
       R"(model.mbd:1:8: error: expected an expression, found the end of the line
let a =
       ^
)"},
      {Finding::Expected, "particle 1 {\n  force = (x1,\n           2 y1)\n}",
       R"(model.mbd:3:14: error: expected an operator, `,` or `)`, found `y1`
           2 y1)
             ^~
model.mbd:2:11: note: `(` opens here
  force = (x1,
          ^
)"},
      {Finding::Expected, "particle 1 {\n  mass = 1\nconstraint : x1",
       R"(model.mbd:3:1: error: expected a field or `}`, found `constraint`
constraint : x1
^~~~~~~~~~
model.mbd:1:12: note: `{` opens here
particle 1 {
           ^
)"},
      {Finding::Expected, "for i in 1..3 {\n  let a = 1\n",
       R"(model.mbd:2:12: error: expected a statement or `}`, found the end of the file
  let a = 1
           ^
model.mbd:1:15: note: `{` opens here
for i in 1..3 {
              ^
)"},
      {Finding::Expected, "module Pendulum(m L) {}", R"(model.mbd:1:19: error: expected `,` or `)`, found `L`
module Pendulum(m L) {}
                  ^
model.mbd:1:16: note: `(` opens here
module Pendulum(m L) {}
               ^
)"},
      {Finding::Expected, "module Pendulum {}", R"(model.mbd:1:17: error: expected `(`, found `{`
module Pendulum {}
                ^
)"},
      {Finding::Expected, "part upper = Pendulum(1, 0.5)",
       R"(model.mbd:1:23: error: expected a name or `)`, found `1`
part upper = Pendulum(1, 0.5)
                      ^
model.mbd:1:22: note: `(` opens here
part upper = Pendulum(1, 0.5)
                     ^
)"},
      {Finding::Expected, "part upper = Pendulum(m, L = 1)", R"(model.mbd:1:24: error: expected `=`, found `,`
part upper = Pendulum(m, L = 1)
                       ^
)"},
      {Finding::Expected, "part upper = Pendulum() (0, 0)",
       R"(model.mbd:1:25: error: expected `{` or the end of the statement, found `(`
part upper = Pendulum() (0, 0)
                        ^
)"},
      {Finding::UnknownStatement, "partcle 1 { mass = 1 }",
       R"(model.mbd:1:1: error: no statement begins with `partcle`; did you mean `particle`?
partcle 1 { mass = 1 }
^~~~~~~
)"},
      {Finding::UnknownStatement, "radius = norm(bob.position)",
       R"(model.mbd:1:1: error: no statement begins with `radius`; did you mean `let radius = ...`?
radius = norm(bob.position)
^~~~~~
)"},
      {Finding::UnknownStatement, "x1^2 + y1^2 = 1", R"(model.mbd:1:1: error: no statement begins with `x1`
x1^2 + y1^2 = 1
^~
)"},
      {Finding::ReservedWord, "parameter speed = 3",
       R"(model.mbd:1:11: error: `speed` is a word of the language and cannot be a name
parameter speed = 3
          ^~~~~
)"},
      {Finding::ReservedWord, "particle sum { mass = 1 }",
       R"(model.mbd:1:10: error: `sum` is a word of the language and cannot be a name
particle sum { mass = 1 }
         ^~~
)"},
      {Finding::LineBeginsWithOperator, "constraint : x1\n  + y1 = 2",
       R"(model.mbd:2:3: error: no statement begins with `+`: to continue a statement in the next line, end the line with the operator
  + y1 = 2
  ^
)"},
      {Finding::UnmatchedBrace, "particle 1 { mass = 1 } }", R"(model.mbd:1:25: error: `}` closes nothing
particle 1 { mass = 1 } }
                        ^
)"},
      {Finding::ConditionExpected, "let a = if(x1 - 1, 2, 3)",
       R"(model.mbd:1:12: error: the first argument of `if` must be a comparison such as `a < b`
let a = if(x1 - 1, 2, 3)
           ^~~~~~
)"},
      {Finding::ComparisonOutsideIf, "let a = (x1 < 3)*2",
       R"(model.mbd:1:13: error: a comparison can stand only as the first argument of `if`
let a = (x1 < 3)*2
            ^
)"},
      {Finding::Inequality, "constraint above : z1 >= 0",
       R"(model.mbd:1:23: error: an inequality is no constraint of this language: constraints are equations
constraint above : z1 >= 0
                      ^~
)"},
      {Finding::EqualsSign, "constraint : x1 == y1",
       R"(model.mbd:1:17: error: `==` compares: an equation has a single `=`
constraint : x1 == y1
                ^~
)"},
      {Finding::NestedTooDeep, "let a = " + times(201, "(\n") + "1" + times(201, ")"),
       R"(model.mbd:202:1: error: brackets and blocks are nested more than 200 deep
1)" + times(201, ")") +
           "\n^\n"},
      {Finding::ExpressionTooLong, "let a = 1 +\n" + times(999, "x1 +\n") + "y1",
       R"(model.mbd:1001:3: error: more than 1000 operators in a row: name a part of the expression with `let`
y1
  ^
)"},
  };
  return all;
}

}  // namespace

TEST_CASE("messages about tokens and grammar") {
  for (const Case& each : cases()) {
    const FrontEnd front_end(each.model);
    INFO(each.model);
    CHECK(front_end.messages() == each.message);
    REQUIRE(front_end.diagnostics.all().size() == 1);
    CHECK(front_end.diagnostics.all().front().finding == each.finding);
  }
}

TEST_CASE("no message about tokens and grammar is left out") {
  std::set<Finding> tested;
  for (const Case& each : cases()) {
    tested.insert(each.finding);
  }
  for (int finding = 0; finding <= static_cast<int>(Finding::ExpressionTooLong); ++finding) {
    INFO(name_of(static_cast<Finding>(finding)));
    CHECK(tested.count(static_cast<Finding>(finding)) == 1);
  }
}

}  // namespace mbcc
