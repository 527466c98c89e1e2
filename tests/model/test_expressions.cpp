#include <catch2/catch.hpp>

#include "resolved.hpp"

namespace mbcc {
namespace {

using test::resolve_text;
using test::shown;

TEST_CASE("expressions keep their shape and get minimal parentheses") {
  CHECK(shown("x1 - (y1 - z1)") == "x1 - (y1 - z1)");
  CHECK(shown("(x1 - y1) - z1") == "x1 - y1 - z1");
  CHECK(shown("x1/(y1*z1)*k") == "x1/(y1*z1)*k");
  CHECK(shown("-x1^2 + (-x1)^2") == "-x1^2 + (-x1)^2");
  CHECK(shown("(x1^k)^m") == "(x1^k)^m");
  CHECK(shown("x1^(k^m)") == "x1^(k^m)");
  CHECK(shown("+x1*-y1") == "x1*-y1");
  CHECK(shown("atan2(x1 + 1, sin(y1))") == "atan2(x1 + 1, sin(y1))");
}

TEST_CASE("what is known when compiling is a number, and only that") {
  CHECK(shown("2*3 + x1") == "6 + x1");
  CHECK(shown("x1 + 2 + 3") == "x1 + 2 + 3");
  CHECK(shown("n*x1", "constant n = 2^3") == "8*x1");
  CHECK(shown("log(100) + ln(exp(2)) + 0^0") == "5");
  CHECK(shown("k*2*3") == "k*2*3");
  CHECK(shown("cos(pi)*x1") == "-1*x1");
}

TEST_CASE("known zeros leave nothing behind") {
  CHECK(shown("x1 + 0") == "x1");
  CHECK(shown("0 - x1") == "-x1");
  CHECK(shown("k*(0, 0, -1)") == "0, 0, k*-1");
  CHECK(shown("dot(bob.position, (0, 1, 0))") == "bob.y*1");
}

TEST_CASE("min, max and hypot take any number of arguments") {
  CHECK(shown("min(x1, y1, z1)") == "min(min(x1, y1), z1)");
  CHECK(shown("max(x1, 1, 2)") == "max(max(x1, 1), 2)");
  CHECK(shown("hypot(x1, y1, z1)") == "hypot(hypot(x1, y1), z1)");
}

TEST_CASE("all comparisons come down to three") {
  CHECK(shown("if(x1 < k, 1, 2)") == "if(x1 < k, 1, 2)");
  CHECK(shown("if(x1 <= k, 1, 2)") == "if(x1 <= k, 1, 2)");
  CHECK(shown("if(x1 > k, 1, 2)") == "if(k < x1, 1, 2)");
  CHECK(shown("if(x1 >= k, 1, 2)") == "if(k <= x1, 1, 2)");
  CHECK(shown("if(x1 == k, 1, 2)") == "if(x1 == k, 1, 2)");
  CHECK(shown("if(x1 != k, 1, 2)") == "if(x1 == k, 2, 1)");
}

TEST_CASE("a condition that is known when compiling is decided, and the other side is not looked at") {
  CHECK(shown("if(1 < 2, x1, 1/0)") == "x1");
  CHECK(shown("if(1 > 2, nothing_like_it, y1)") == "y1");
  CHECK(shown("if(1 != 1, x1, y1)") == "y1");
  CHECK(shown("sum(j in 1..3, if(j != 2, x1/(j - 2), 0))") == "x1/-1 + x1/1");
}

TEST_CASE("sums are unrolled from their first to their last index") {
  CHECK(shown("sum(j in 1..3, j*x1)") == "1*x1 + 2*x1 + 3*x1");
  CHECK(shown("sum(j in -1..1, j)") == "0");
  CHECK(shown("sum(i in 1..2, sum(j in i..2, i*j*x1))") == "1*x1 + 2*x1 + 4*x1");
  CHECK(shown("sum(j in 1..2, j*bob.position)") == "1*bob.x + 2*bob.x, 1*bob.y + 2*bob.y, 1*bob.z + 2*bob.z");
}

TEST_CASE("rates are derivatives along the motion") {
  CHECK(shown("x1'") == "x1'");
  CHECK(shown("(x1*y1)'") == "(x1*y1)'");
  CHECK(shown("x1''") == "x1''");
  CHECK(shown("bob.position'") == "bob.x', bob.y', bob.z'");
  CHECK(shown("(k*2)' + x1") == "x1");
}

TEST_CASE("vectors work component by component") {
  CHECK(shown("(x1, y1, z1) - bob.position") == "x1 - bob.x, y1 - bob.y, z1 - bob.z");
  CHECK(shown("2*(x1, y1)/k") == "2*x1/k, 2*y1/k");
  CHECK(shown("-(x1, y1)") == "-x1, -y1");
  CHECK(shown("(x1, y1)*k") == "x1*k, y1*k");
  CHECK(shown("d.x + d.y", "let d = (x1, y1)") == "x1 + y1");
  CHECK(shown("bob.velocity.z") == "bob.vz");
  CHECK(shown("if(x1 < 0, (x1, y1), 0)") == "$1 = x1 < 0; if($1, x1, 0), if($1, y1, 0)");
}

TEST_CASE("dot, cross and norm are written out") {
  CHECK(shown("dot((x1, y1), (k, m))") == "x1*k + y1*m");
  CHECK(shown("cross((x1, y1), (k, m))") == "x1*m - y1*k");
  CHECK(shown("cross((x1, y1, z1), (1, 2, 3))") == "y1*3 - z1*2, z1*1 - x1*3, x1*2 - y1*1");
  CHECK(shown("norm((x1, y1))") == "sqrt(x1^2 + y1^2)");
  CHECK(shown("norm((3, 4))") == "5");
}

TEST_CASE("the square of a norm has no root in it") {
  CHECK(shown("norm((x1, y1))^2") == "x1^2 + y1^2");
  CHECK(shown("(norm((x1, y1)))^2") == "x1^2 + y1^2");
  CHECK(shown("r^2", "let r = norm((x1, y1))") == "x1^2 + y1^2");
  CHECK(shown("norm((x1, y1))^3") == "sqrt(x1^2 + y1^2)^3");
  CHECK(shown("sqrt(x1)^2") == "sqrt(x1)^2");
}

TEST_CASE("a `let` is computed once, however often it is used") {
  CHECK(shown("r + r^2", "let r = x1 - y1") == "$1 = x1 - y1; $1 + $1^2");
  std::string chain = "let a0 = x1 + y1\n";
  for (int i = 1; i <= 200; ++i) {
    const std::string before = "a" + std::to_string(i - 1);
    chain += "let a" + std::to_string(i) + " = " + before + "*" + before + "\n";
  }
  const model::System system =
      test::system_of("particle 1 { mass = 1; position = (1, 0, 0) }\n" + chain + "output last = a200\n");
  const std::size_t of_particle = 6;  // numbers 1 and 0, three rates, and one more for the leaves below
  CHECK(system.expressions.size() < of_particle + 2 + 1 + 200 + 1);
}

TEST_CASE("long sums and deep brackets are no trouble") {
  std::string sum = "x1";
  for (int i = 0; i < 900; ++i) {
    sum += " + x1";
  }
  CHECK(resolve_text("particle 1 { mass = 1; position = (0, 0, 0); force = (" + sum + ", 0, 0) }").system);
  CHECK(resolve_text("particle 1 { mass = 1; position = (0, 0, 0); force = (" + std::string(150, '(') + "x1" +
                     std::string(150, ')') + ", 0, 0) }")
            .system);
}

TEST_CASE("numbers, the time and members mean what they say") {
  CHECK(shown("t") == "t");
  CHECK(shown("x2 + vy1 + bob.z + bob.vx") == "x2 + vy1 + bob.z + bob.vx");
  CHECK(shown("pi") == "3.141592653589793");
}

}  // namespace
}  // namespace mbcc
