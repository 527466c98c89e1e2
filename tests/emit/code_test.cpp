// Pieces of C++: literals, parentheses, identifiers, templates.

#include "emit/code.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "emit/names.hpp"
#include "emit/templates.hpp"
#include "support/random.hpp"

namespace mbcc::cpp {
namespace {

using graph::Operator;

Code name(const char* text) { return {text, Binding::Primary}; }
const Code a = name("a"), b = name("b"), c = name("c");

Code operator+(const Code& x, const Code& y) { return compose(Operator::Add, {x, y}); }
Code operator-(const Code& x, const Code& y) { return compose(Operator::Subtract, {x, y}); }
Code operator*(const Code& x, const Code& y) { return compose(Operator::Multiply, {x, y}); }
Code operator/(const Code& x, const Code& y) { return compose(Operator::Divide, {x, y}); }
Code operator-(const Code& x) { return compose(Operator::Negate, {x}); }
Code operator<(const Code& x, const Code& y) { return compose(Operator::Less, {x, y}); }

}  // namespace

TEST_CASE("literals read back as the same double, and are doubles") {
  test::Random random(1);
  std::vector<double> numbers = {0,
                                 -0.0,
                                 1,
                                 -1,
                                 0.1,
                                 1e300,
                                 1e22,
                                 123456789,
                                 std::numeric_limits<double>::max(),
                                 std::numeric_limits<double>::min(),
                                 std::numeric_limits<double>::denorm_min(),
                                 std::nextafter(1.0, 2.0)};
  for (int i = 0; i < 10000; ++i) {
    numbers.push_back(std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(2000)) - 1000));
  }
  for (const double number : numbers) {
    const Code code = literal(number);
    CAPTURE(code.text);
    const double back = std::strtod(code.text.c_str(), nullptr);
    CHECK(back == number);
    CHECK(std::signbit(back) == std::signbit(number));
    CHECK(code.text.find_first_of(".e") != std::string::npos);
    CHECK(code.binding == (std::signbit(number) ? Binding::Prefix : Binding::Primary));
  }
}

TEST_CASE("no parentheses but those that are needed") {
  CHECK((a + b + c).text == "a + b + c");
  CHECK((a + (b + c)).text == "a + (b + c)");  // not the same in floating point
  CHECK((a - (b - c)).text == "a - (b - c)");
  CHECK((a - b * c).text == "a - b * c");
  CHECK(((a - b) * c).text == "(a - b) * c");
  CHECK((a / b / c).text == "a / b / c");
  CHECK((a / (b * c)).text == "a / (b * c)");
  CHECK((a * (b / c)).text == "a * (b / c)");
  CHECK((-a * b).text == "-a * b");
  CHECK((-(a * b)).text == "-(a * b)");
  CHECK((-(-a)).text == "-(-a)");  // not `--a`
  CHECK((a - -b).text == "a - -b");
  CHECK((a - literal(-2)).text == "a - -2.0");
  CHECK((-literal(-2)).text == "-(-2.0)");
  CHECK(compose(Operator::Sin, {a + b}).text == "std::sin(a + b)");
  CHECK(compose(Operator::Power, {a + b, -c}).text == "std::pow(a + b, -c)");
  CHECK(compose(Operator::Min, {a, b}).text == "mbrt::min(a, b)");
  CHECK(compose(Operator::If, {a < b, a + b, c}).text == "a < b ? a + b : c");
  CHECK((compose(Operator::If, {a < b, a, b}) + c).text == "(a < b ? a : b) + c");
  CHECK(compose(Operator::If, {a, b, c}).text == "a != 0.0 ? b : c");
  CHECK(compose(Operator::If, {a < b, compose(Operator::If, {b < c, a, b}), c}).text == "a < b ? (b < c ? a : b) : c");
  CHECK((literal(1) - (a < b)).text == "1.0 - (a < b)");
  CHECK(((a < b) < c).text == "(a < b) < c");
}

TEST_CASE("names of the model become identifiers") {
  CHECK(mangle("x1") == "x1");
  CHECK(mangle("bob.vx") == "bob_vx");
  CHECK(mangle("p[3].x") == "p_3_x");
  CHECK(mangle("p[1, 2].x") == "p_1_2_x");
  CHECK(mangle("_x") == "x");
  CHECK(mangle("x__y") == "x_y");
  CHECK(mangle("double_") == "double_v");
  for (const char* word :
       {"class", "int",  "std",  "mbrt", "Model",  "State",   "y",       "rate",   "main",    "errno",
        "linux", "NULL", "M_PI", "EOF",  "assert", "climb_1", "rows_12", "island", "signbit", "xor"}) {
    CHECK(mangle(word) == std::string(word) + "_v");
  }
}

TEST_CASE("a file that is called like a function of the C library gives its namespace another name") {
  for (const char* const name : {"exp", "nan", "sinf", "y1", "select", "gamma", "clock"}) {
    CHECK(is_global_name(name));
  }
  for (const char* const name : {"pendulum", "whitworth", "f", "l", ""}) {
    CHECK_FALSE(is_global_name(name));
  }
}

TEST_CASE("identifiers of one scope are distinct, and valid") {
  Scope scope;
  std::set<std::string> seen;
  for (const char* model_name :
       {"p[1].x", "p_1_x", "p_1.x", "p_1_x_2", "_", "__", "1", "class", "class_v", "e1", "E"}) {
    const std::string identifier = scope.declare(model_name);
    INFO(identifier);
    CHECK(seen.insert(identifier).second);
    CHECK(identifier.find("__") == std::string::npos);
    CHECK(std::isalpha(static_cast<unsigned char>(identifier.front())) != 0);
    CHECK(identifier.back() != '_');  // those are members
  }
  CHECK(scope.enumerate("e") == "e2");  // e1 is taken
  CHECK(scope.enumerate("e") == "e3");
  CHECK(scope.enumerate("s") == "s1");
}

TEST_CASE("templates are text with places") {
  CHECK(fill("a @x@ b @y_z@\n", {{"x", "1"}, {"y_z", "2"}}) == "a 1 b 2\n");
  CHECK(fill("  @block@\nend\n", {{"block", "one\n\n  two\n"}}) == "  one\n\n    two\nend\n");
  CHECK(fill("  @block@\nend\n", {{"block", ""}}) == "end\n");
  CHECK(fill("mail@host and @ @1@\n", {}) == "mail@host and @ @1@\n");
  CHECK(fill("@x@@x@\n", {{"x", "@y@"}}) == "@y@@y@\n");  // values are not looked into
  CHECK(fill("no line end @x@", {{"x", "1"}}) == "no line end 1");
}

TEST_CASE("template texts are there under the names of their files") {
  for (const char* file : {"model.hpp.in", "simulation.cpp.in", "model_class.in"}) {
    CHECK(template_text(file).size() > 100);
  }
}

}  // namespace mbcc::cpp
