// Tokens: their classes, their places, and the line ends that separate statements.

#include <catch2/catch.hpp>

#include "syntax/front_end.hpp"

namespace mbcc {
namespace {

/// The tokens with a blank between them; `/` for a line end that separates.
std::string tokens_of(const std::string& text) {
  const FrontEnd front_end(text);
  std::string all;
  for (const Token& token : front_end.tokens) {
    if (token.kind != TokenKind::EndOfFile) {
      all += (all.empty() ? "" : " ") + (token.text.empty() ? "/" : std::string(token.text));
    }
  }
  return all;
}

}  // namespace

TEST_CASE("a dump of tokens shows place, class and text") {
  const FrontEnd front_end("let a_1 = 2.5e+6  # half\nfor i in 1..N { body }; \"x y\"'");
  CHECK(print(front_end.tokens, front_end.sources) == R"(1:1     Let           let
1:5     Name          a_1
1:9     Equal         =
1:11    Real          2.5e+6
1:17    Separator
2:1     For           for
2:5     Name          i
2:7     Name          in
2:10    Natural       1
2:11    DotDot        ..
2:13    Name          N
2:15    BraceLeft     {
2:17    LaterWord     body
2:22    BraceRight    }
2:23    Separator     ;
2:25    Text          "x y"
2:30    Prime         '
2:31    EndOfFile
)");
}

TEST_CASE("a dot before a dot belongs to no number") {
  CHECK(tokens_of("1..N") == "1 .. N");
  CHECK(tokens_of("1...5") == "1 .. .5");
  CHECK(tokens_of("1. .5") == "1. .5");
  CHECK(tokens_of("1.5.5") == "1.5 .5");
  CHECK(tokens_of("p.x p[1].x") == "p . x p [ 1 ] . x");
}

TEST_CASE("an exponent needs its digits") { CHECK(tokens_of("1e5 1e 1e+ 1.e-2 .5E3") == "1e5 1 e 1 e + 1.e-2 .5E3"); }

TEST_CASE("line ends separate statements") {
  CHECK(tokens_of("a\n\n\nb\n") == "a / b");
  CHECK(tokens_of("a # comment\n# comment\n  b") == "a / b");
  CHECK(tokens_of("a\r\nb") == "a / b");
  CHECK(tokens_of("a;\nb;;c") == "a ; b ; ; c");
}

TEST_CASE("an unfinished line goes on in the next") {
  for (const std::string last : {"+", "-", "*", "/", "^", ",", "=", ":", "..", "<", "<=", ">", ">=", "==", "!="}) {
    CHECK(tokens_of("a " + last + " # comment\n\n b") == "a " + last + " b");
  }
  CHECK(tokens_of("a\n+ b") == "a / + b");
  CHECK(tokens_of("f(a\n, b)\nc[i\n]\nd") == "f ( a , b ) / c [ i ] / d");
  CHECK(tokens_of("a\n{\nb\n}\nc") == "a { b / } / c");
}

TEST_CASE("no line goes on before a statement's word") {
  CHECK(tokens_of("a = (b +\nlet c") == "a = ( b + / let c");
  CHECK(tokens_of("a = (b +\nbody c\nd") == "a = ( b + / body c / d");
  CHECK(tokens_of("a = (b +\nif(c, d, e))") == "a = ( b + if ( c , d , e ) )");
}

TEST_CASE("braces and semicolons end what brackets left open") {
  CHECK(tokens_of("(a\nb; c\nd") == "( a b ; c / d");
  CHECK(tokens_of("{ (a\nb }\nc") == "{ ( a b } / c");
  CHECK(tokens_of("a)\nb") == "a ) / b");
}

TEST_CASE("a byte order mark is no token") { CHECK(tokens_of("\xEF\xBB\xBFlet") == "let"); }

TEST_CASE("an empty text has one token") {
  CHECK(tokens_of("").empty());
  CHECK(tokens_of(" \n# nothing\n").empty());
  CHECK(FrontEnd("").tokens.size() == 1);
}

TEST_CASE("every kind of token has a name and a description") {
  CHECK(describe(TokenKind::EndOfFile) == "the end of the file");
  CHECK(describe(TokenKind::ParenRight) == "`)`");
  CHECK(describe(TokenKind::Particle) == "`particle`");
  CHECK(name_of(TokenKind::DotDot) == "DotDot");
}

}  // namespace mbcc
