// grammar/model.ebnf and the lexer and parser define the same language.

#include <catch2/catch.hpp>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "syntax/derive.hpp"
#include "syntax/front_end.hpp"
#include "syntax/recognise.hpp"
#include "syntax/spoil.hpp"

namespace mbcc {
namespace {

using ebnf::Deriver;
using ebnf::Grammar;
using ebnf::joined;
using ebnf::Node;
using ebnf::Recogniser;
using ebnf::spoil;

const std::map<std::string, TokenKind> token_classes = {
    {"name", TokenKind::Name}, {"natural", TokenKind::Natural},     {"real", TokenKind::Real},
    {"text", TokenKind::Text}, {"separator", TokenKind::Separator}, {"later_word", TokenKind::LaterWord}};

std::set<std::string> token_names() {
  std::set<std::string> names;
  for (const auto& [name, kind] : token_classes) {
    names.insert(name);
  }
  return names;
}

const Grammar& grammar() {
  static const Grammar model = ebnf::read_file(MBCC_SOURCE_DIR "/grammar/model.ebnf");
  return model;
}

const std::set<std::string>& words() {
  static const std::set<std::string> all = ebnf::literals_of(grammar(), "word");
  return all;
}

/// Numbers that no double holds, and names that are words, follow the grammar and are refused all the same.
bool is_usable(const std::string& token) {
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error != std::errc::result_out_of_range;
}

std::vector<std::string> usable_sentence(Deriver& deriver, std::string_view production) {
  while (true) {
    std::vector<std::string> sentence = deriver.sentence(production);
    if (std::all_of(sentence.begin(), sentence.end(), is_usable)) {
      return sentence;
    }
  }
}

bool grammar_accepts(const TokenBuffer& tokens) {
  const auto terminal = [&tokens](const Node& node, std::size_t place) -> std::optional<std::size_t> {
    const Token& token = tokens[place];
    if (node.kind == ebnf::Kind::Literal) {
      return token.text == node.text ? place + 1 : Recogniser::npos;
    }
    const auto token_class = token_classes.find(node.text);
    if (token_class == token_classes.end()) {
      return std::nullopt;
    }
    return token.kind == token_class->second ? place + 1 : Recogniser::npos;
  };
  return Recogniser(grammar(), tokens.size() - 1, terminal).accepts(grammar().start);
}

/// Every literal of the language, and some tokens of each class.
std::vector<std::string> token_pool(Deriver& deriver) {
  std::set<std::string> literals = ebnf::literals_of(grammar(), "statements");
  literals.erase("\"");  // no token alone
  std::vector<std::string> pool(literals.begin(), literals.end());
  for (const auto& [name, kind] : token_classes) {
    for (int i = 0; i < 8; ++i) {
      pool.push_back(deriver.token(name));
    }
  }
  pool.erase(std::remove_if(pool.begin(), pool.end(), [](const std::string& token) { return !is_usable(token); }),
             pool.end());
  return pool;
}

/// The examples and two models that use all of the language, in a fixed order.
std::vector<std::string> model_paths() {
  const std::string seeds = MBCC_SOURCE_DIR "/tests/fuzz/seeds/";
  std::vector<std::string> paths = {seeds + "everything.mbd", seeds + "later.mbd"};
  for (const auto& entry : std::filesystem::recursive_directory_iterator(MBCC_SOURCE_DIR "/examples")) {
    if (entry.path().extension() == ".mbd") {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

}  // namespace

TEST_CASE("every production of the model's grammar is defined, reachable and productive") {
  CHECK(ebnf::undefined_names(grammar()).empty());
  CHECK(ebnf::unreachable_names(grammar()).empty());
  CHECK(ebnf::unproductive_names(grammar()).empty());
}

TEST_CASE("the grammar and the token table know the same words and signs") {
  const std::set<std::string> table_words = {
#define MBCC_WORD(name, spelling) spelling,
#define MBCC_LATER_WORD(spelling) spelling,
#include "syntax/tokens.def"
  };
  const std::set<std::string> later_words = {
#define MBCC_LATER_WORD(spelling) spelling,
#include "syntax/tokens.def"
  };
  const std::set<std::string> table_signs = {
#define MBCC_SYMBOL(name, spelling) spelling,
#include "syntax/tokens.def"
  };
  CHECK(words() == table_words);
  CHECK(ebnf::literals_of(grammar(), "later_word") == later_words);
  std::set<std::string> signs = ebnf::literals_of(grammar(), "bracket");
  signs.merge(ebnf::literals_of(grammar(), "mark"));
  signs.insert({"{", "}"});
  CHECK(signs == table_signs);
}

TEST_CASE("the lexer reads each token that the grammar derives") {
  for (const auto& [name, kind] : token_classes) {
    Deriver deriver(grammar(), {}, 1);
    for (int i = 0; i < 2000; ++i) {
      const std::string token = deriver.token(name);
      if (kind == TokenKind::Name && words().count(token) != 0) {
        continue;
      }
      Sources sources;
      sources.add("model.mbd", token);
      Diagnostics diagnostics;
      const TokenBuffer tokens = lex(sources, 0, diagnostics);
      INFO(name << " " << token);
      REQUIRE(tokens.size() == 2);
      CHECK(tokens[0].kind == kind);
      CHECK(tokens[0].text == token);
      CHECK(diagnostics.all().empty());
    }
  }
}

TEST_CASE("the lexer and the grammar agree on tokens with one character changed") {
  const std::string characters = "019.eE+-_az\" ;'xé";
  std::size_t accepted = 0, refused = 0;
  for (const auto& [name, kind] : token_classes) {
    Deriver deriver(grammar(), {}, 2);
    for (int i = 0; i < 3000; ++i) {
      std::string token = deriver.token(name);
      const std::size_t place = deriver.below(token.size());
      token.replace(place, deriver.below(2), deriver.below(3) == 0 ? "" : std::string(1, deriver.any_of(characters)));
      Sources sources;
      sources.add("model.mbd", token);
      Diagnostics diagnostics;
      const TokenBuffer tokens = lex(sources, 0, diagnostics);
      const bool is_one = diagnostics.all().empty() && tokens.size() == 2 && tokens[0].text == token;
      const bool is_word = words().count(token) != 0;
      const bool made = ebnf::makes(grammar(), name, token) && !(kind == TokenKind::Name && is_word);
      INFO(name << " `" << token << "`");
      CHECK((is_one && tokens[0].kind == kind) == made);
      ++(made ? accepted : refused);
    }
  }
  CHECK(accepted > 500);
  CHECK(refused > 500);
}

TEST_CASE("the parser accepts each sentence that the grammar derives") {
  Deriver deriver(grammar(), token_names(), 3);
  std::set<std::string_view> seen;
  for (int i = 0; i < 5000; ++i) {
    const FrontEnd front_end(joined(usable_sentence(deriver, grammar().start), " "));
    for (const Token& token : front_end.tokens) {
      seen.insert(describe(token.kind));
    }
    INFO(front_end.sources[0].text() << "\n" << front_end.messages());
    REQUIRE(front_end.accepted());
  }
  CHECK(seen.size() == token_kinds);  // the sentences leave no token out
}

TEST_CASE("the parser and the grammar agree on statements with one token changed") {
  Deriver deriver(grammar(), token_names(), 4);
  const std::vector<std::string> pool = token_pool(deriver);
  std::size_t accepted = 0, refused = 0;
  while (accepted + refused < 10000) {
    std::vector<std::string> sentence = usable_sentence(deriver, "statement");
    if (sentence.size() > 40) {
      continue;  // long ones take the recogniser's time, and change in few places of the grammar
    }
    spoil(sentence, pool, deriver);
    // With each token on its own line the lexer decides which line ends separate statements.
    const FrontEnd front_end(joined(sentence, deriver.below(4) == 0 ? "\n" : " "));
    const bool should_accept = grammar_accepts(front_end.tokens);
    INFO(front_end.sources[0].text() << "\n" << front_end.messages());
    REQUIRE(front_end.accepted() == should_accept);
    ++(should_accept ? accepted : refused);
  }
  CHECK(accepted > 1000);
  CHECK(refused > 1000);
}

TEST_CASE("the parser and the grammar agree on models that people wrote, with and without one token") {
  for (const std::string& path : model_paths()) {
    const FrontEnd whole(text_of(path));
    std::vector<std::string> sentence;
    for (const Token& token : whole.tokens) {
      sentence.push_back(token.kind == TokenKind::Separator ? ";" : std::string(token.text));
    }
    sentence.pop_back();
    INFO(path << "\n" << whole.messages());
    CHECK(whole.accepted());
    CHECK(grammar_accepts(whole.tokens));
    Deriver deriver(grammar(), token_names(), 5);
    for (int i = 0; i < 20; ++i) {
      std::vector<std::string> shorter = sentence;
      shorter.erase(shorter.begin() + static_cast<std::ptrdiff_t>(deriver.below(shorter.size())));
      const FrontEnd front_end(joined(shorter, " "));
      INFO(front_end.sources[0].text() << "\n" << front_end.messages());
      CHECK(front_end.accepted() == grammar_accepts(front_end.tokens));
    }
  }
}

}  // namespace mbcc
