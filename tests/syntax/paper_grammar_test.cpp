// grammar/paper.ebnf and `--strict` define the same expressions.

#include <catch2/catch.hpp>
#include <charconv>

#include "syntax/derive.hpp"
#include "syntax/front_end.hpp"
#include "syntax/recognise.hpp"
#include "syntax/spoil.hpp"

namespace mbcc {
namespace {

using ebnf::Deriver;
using ebnf::Grammar;
using ebnf::Node;
using ebnf::Recogniser;

const std::set<std::string> token_names = {"variable", "natural", "decimal", "scientific", "function"};

const Grammar& grammar() {
  static const Grammar paper = ebnf::read_file(MBCC_SOURCE_DIR "/grammar/paper.ebnf");
  return paper;
}

bool fits_a_double(const std::string& token) {
  double value = 0;
  return std::from_chars(token.data(), token.data() + token.size(), value).ec != std::errc::result_out_of_range;
}

std::vector<std::string> expression(Deriver& deriver) {
  while (true) {
    std::vector<std::string> sentence = deriver.sentence(grammar().start);
    if (std::all_of(sentence.begin(), sentence.end(), fits_a_double)) {
      return sentence;
    }
  }
}

bool grammar_accepts(const std::vector<std::string>& sentence) {
  const auto terminal = [&sentence](const Node& node, std::size_t place) -> std::optional<std::size_t> {
    const bool is_class = token_names.count(node.text) != 0;
    if (node.kind == ebnf::Kind::Name && !is_class) {
      return std::nullopt;
    }
    const bool stands_here = place < sentence.size() && (is_class ? ebnf::makes(grammar(), node.text, sentence[place])
                                                                  : sentence[place] == node.text);
    return stands_here ? place + 1 : Recogniser::npos;
  };
  return Recogniser(grammar(), sentence.size(), terminal).accepts(grammar().start);
}

std::string as_constraint(const std::vector<std::string>& sentence) {
  return "constraint : " + ebnf::joined(sentence, " ");
}

std::string as_force(const std::vector<std::string>& sentence) {
  return "particle 1 { force = (" + ebnf::joined(sentence, " ") + ", 1, x1) }";
}

/// What occurs in the paper's expressions, and what occurs in mbcc's only.
std::vector<std::string> token_pool(Deriver& deriver) {
  std::vector<std::string> pool = {
      "sin",   "cos",   "tan",   "asin", "acos", "atan", "exp",   "ln",  "log", "sinh", "cosh", "tanh", "asinh",
      "acosh", "atanh", "sqrt",  "abs",  "if",   "sum",  "t",     "x1",  "vy2", "z10",  "x0",   "vy",   "v1",
      "t12",   "y",     "bob",   "pi",   "w1",   "xx",   "x1a",   "0",   "12",  "1.",   "1.50", ".5",   ".25",
      "1e5",   "1.e5",  "2.5e6", ".5e0", "1e10", "1e+5", "1e-05", "1E5", "+",   "-",    "*",    "/",    "^",
      "(",     ")",     "[",     "]",    "=",    ",",    "'",     "..",  ".",   "<"};
  for (const std::string& name : token_names) {
    for (int i = 0; i < 8; ++i) {
      pool.push_back(deriver.token(name));
    }
  }
  pool.erase(std::remove_if(pool.begin(), pool.end(), [](const std::string& token) { return !fits_a_double(token); }),
             pool.end());
  return pool;
}

}  // namespace

TEST_CASE("every production of the paper's grammar is defined, reachable and productive") {
  CHECK(ebnf::undefined_names(grammar()).empty());
  CHECK(ebnf::unreachable_names(grammar()).empty());
  CHECK(ebnf::unproductive_names(grammar()).empty());
}

TEST_CASE("the flag --strict accepts each expression that the paper's grammar derives") {
  Deriver deriver(grammar(), token_names, 5);
  for (int i = 0; i < 5000; ++i) {
    const std::vector<std::string> sentence = expression(deriver);
    const StrictFrontEnd front_end(i % 2 == 0 ? as_constraint(sentence) : as_force(sentence));
    INFO(front_end.sources[0].text() << "\n" << front_end.messages());
    REQUIRE(front_end.accepted());
  }
}

TEST_CASE("the flag --strict and the paper's grammar agree on expressions with one token changed") {
  Deriver deriver(grammar(), token_names, 6);
  const std::vector<std::string> pool = token_pool(deriver);
  std::size_t accepted = 0, refused = 0;
  while (accepted + refused < 6000) {
    std::vector<std::string> sentence = expression(deriver);
    ebnf::spoil(sentence, pool, deriver);
    const StrictFrontEnd front_end(as_constraint(sentence));
    const bool should_accept = grammar_accepts(sentence);
    INFO(front_end.sources[0].text() << "\n" << front_end.messages());
    REQUIRE(front_end.accepted() == should_accept);
    ++(should_accept ? accepted : refused);
  }
  CHECK(accepted > 500);
  CHECK(refused > 500);
}

}  // namespace mbcc
