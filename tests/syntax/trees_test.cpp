// Trees: how expressions and statements are read. The dump writes expressions operator first.

#include <catch2/catch.hpp>

#include "syntax/front_end.hpp"

namespace mbcc {
namespace {

std::string tree_of(const std::string& text) {
  const FrontEnd front_end(text);
  return print(front_end.model) + front_end.messages();
}

/// The dump of one expression, and of what was found wrong with it.
std::string read_as(const std::string& expression) {
  const std::string tree = tree_of("gravity " + expression);
  return tree.substr(8, tree.size() - 9);
}

/// The text of an expression's span.
std::string_view span_text(const FrontEnd& front_end, Span span) { return front_end.sources.text(span); }

}  // namespace

TEST_CASE("operators bind by precedence and to the left") {
  CHECK(read_as("a - b - c") == "(- (- a b) c)");
  CHECK(read_as("a/b*c") == "(* (/ a b) c)");
  CHECK(read_as("a + b*c^d") == "(+ a (* b (^ c d)))");
  CHECK(read_as("a^b^c") == "(^ (^ a b) c)");
  CHECK(read_as("(a + b)*c") == "(* (group (+ a b)) c)");
}

TEST_CASE("signs bind between powers and products") {
  CHECK(read_as("-x^2") == "(- (^ x 2))");
  CHECK(read_as("2^-1") == "(^ 2 (- 1))");
  CHECK(read_as("2^-1^3") == "(^ (^ 2 (- 1)) 3)");
  CHECK(read_as("-a*b") == "(* (- a) b)");
  CHECK(read_as("a*-b") == "(* a (- b))");
  CHECK(read_as("a - -+b") == "(- a (- (+ b)))");
}

TEST_CASE("a prime binds tightest") {
  CHECK(read_as("theta'^2") == "(^ (rate theta) 2)");
  CHECK(read_as("-x1''") == "(- (rate (rate x1)))");
  CHECK(read_as("(x1*y1)'") == "(rate (group (* x1 y1)))");
  CHECK(read_as("p[1].x'") == "(rate p[1].x)");
  CHECK(read_as("sin(x1)'") == "(rate (sin x1))");
}

TEST_CASE("operands") {
  CHECK(read_as("3") == "3");
  CHECK(read_as("2.5E+6") == "2500000");
  CHECK(read_as(".5") == "0.5");
  CHECK(read_as("p[i, j + 1].position.x") == "p[i, (+ j 1)].position.x");
  CHECK(read_as("(a, b, c)") == "(vector a b c)");
  CHECK(read_as("max(a, b)") == "(max a b)");
  CHECK(read_as("if(a <= b, c, d)") == "(if (<= a b) c d)");
  CHECK(read_as("sum(j in 1..N, if(j != i, x[j], 0))") == "(sum j 1 .. N (if (!= j i) x[j] 0))");
}

TEST_CASE("words of statements are names behind a dot, and `in` and `on` are names elsewhere") {
  CHECK(read_as("p.force + bob.state[2]") == "(+ p.force bob.state[2])");
  CHECK(tree_of("let in = 1; let on = in") == "let in = 1\nlet on = in\n");
}

TEST_CASE("natural numbers are told from others") {
  const FrontEnd front_end("dimension 3; dimension 3.");
  const auto is_natural = [&](std::size_t i) {
    const auto& statement = std::get<ast::Dimension>(front_end.model.statements[i].node);
    return std::get<ast::Number>(statement.value.node).is_natural;
  };
  CHECK(is_natural(0));
  CHECK_FALSE(is_natural(1));
}

TEST_CASE("statements") {
  CHECK(tree_of(R"(system artigo5; dimension 3
import "a b.mbd"
constant N = 2; parameter L = 0.5
let r[i] = L
particle 1 { mass = 1; force = (1, 2, 3) }
particle p[i, j] { }
constraint : a
constraint link[i] : a = b = c
force on 1 = 2; force on p[1] = (1, 2)
gravity (0, -9.81)
output height = z1
for i in 1..N { let q[i] = i; for j in i..N { constraint : x } }
integrate { from = 0; method = rk4 }
module Arm(m, L = 2*m) { port root; point tip[i] = root; module Hand() {
} }
part arm[1] = Arm(m = 1, L = 2) { root = (0, 0); tip = a }; part hand = Hand()
body rod { mass = 1
  { x } } )") == R"(system artigo5
dimension 3
import "a b.mbd"
constant N = 2
parameter L = 0.5
let r[i] = L
particle 1
  mass = 1
  force = (vector 1 2 3)
particle p[i, j]
constraint : a
constraint link[i] : a = b = c
force on 1 = 2
force on p[1] = (vector 1 2)
gravity (vector 0 (- 9.81))
output height = z1
for i in 1 .. N
  let q[i] = i
  for j in i .. N
    constraint : x
integrate
  from = 0
  method = rk4
module Arm m L = (* 2 m)
  port root
  point tip[i] = root
  module Hand
part arm[1] = Arm
  m = 1
  L = 2
  ports
  root = (vector 0 0)
  tip = a
part hand = Hand
unsupported body
)");
}

TEST_CASE("trees know their places") {
  const FrontEnd front_end("let a = 1\nconstraint rod[2] : (x1 + y1)^2 = -f(3)'\n");
  const ast::Statement& statement = front_end.model.statements.at(1);
  CHECK(span_text(front_end, statement.span) == "constraint rod[2] : (x1 + y1)^2 = -f(3)'");
  CHECK(span_text(front_end, statement.keyword_span) == "constraint");
  const auto& constraint = std::get<ast::Constraint>(statement.node);
  CHECK(span_text(front_end, constraint.label->span) == "rod[2]");
  CHECK(span_text(front_end, constraint.sides[0].span) == "(x1 + y1)^2");
  CHECK(span_text(front_end, constraint.sides[1].span) == "-f(3)'");
  const auto& power = std::get<ast::Binary>(constraint.sides[0].node);
  CHECK(span_text(front_end, power.op_span) == "^");
  CHECK(span_text(front_end, power.operands[0].span) == "(x1 + y1)");
}

TEST_CASE("trees know their height") {
  const auto height = [](const std::string& expression) {
    const FrontEnd front_end("gravity " + expression);
    return std::get<ast::Gravity>(front_end.model.statements.at(0).node).value.height;
  };
  CHECK(height("1") == 1);
  CHECK(height("a + b + c") == 3);
  CHECK(height("a[b + c]") == 3);
  CHECK(height("-(a, b*c)'") == 5);
  CHECK(height("sum(i in 1..2*3, f(1))") == 3);
}

}  // namespace mbcc
