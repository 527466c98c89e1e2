#pragma once
// The terminals of the grammar as parsers of Spirit X3. Included by parser.cpp alone.

#include <boost/spirit/home/x3.hpp>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

#include "syntax/syntax_error.hpp"
#include "syntax/token.hpp"

namespace mbcc::grammar {

namespace x3 = boost::spirit::x3;

/// What all rules share while they run.
struct State {
  SyntaxErrors errors;
  std::size_t nesting = 0;
};
struct state_tag;

template <class Context>
State& state(const Context& context) {
  return x3::get<state_tag>(context).get();
}

/// One token for which the predicate holds; its attribute is the Token. `expected` is its name in messages.
template <class Predicate>
struct TokenParser : x3::parser<TokenParser<Predicate>> {
  using attribute_type = Token;
  static constexpr bool has_attribute = true;

  TokenParser(Predicate predicate, std::string_view what) : accepts(predicate), expected(what) {}

  template <class Context, class RuleContext, class Attribute>
  bool parse(TokenIterator& first, const TokenIterator& last, const Context&, RuleContext&,
             Attribute& attribute) const {
    if (first == last || !accepts(*first)) {
      return false;
    }
    x3::traits::move_to(*first, attribute);
    ++first;
    return true;
  }

  Predicate accepts;
  std::string_view expected;
};

template <class Predicate>
auto token_where(Predicate accepts, std::string_view expected) {
  return TokenParser<Predicate>(accepts, expected);
}

inline auto token(TokenKind kind, std::string_view expected) {
  return token_where([kind](const Token& token) { return token.kind == kind; }, expected);
}
inline auto token(TokenKind kind) { return token(kind, describe(kind)); }

/// A word that is special in one place only, and a name elsewhere.
inline auto contextual(std::string_view word, std::string_view expected) {
  return token_where([word](const Token& token) { return token.text == word; }, expected);
}

/// Its subject one level deeper; the parse fails where the levels become too many.
template <class Subject>
struct NestedDirective : x3::unary_parser<Subject, NestedDirective<Subject>> {
  static constexpr bool is_pass_through_unary = true;
  using x3::unary_parser<Subject, NestedDirective<Subject>>::unary_parser;

  template <class Context, class RuleContext, class Attribute>
  bool parse(TokenIterator& first, const TokenIterator& last, const Context& context, RuleContext& rule_context,
             Attribute& attribute) const {
    struct Level {
      std::size_t& nesting;
      explicit Level(std::size_t& counter) : nesting(counter) { ++nesting; }
      ~Level() { --nesting; }
    } level(state(context).nesting);
    if (level.nesting > max_nesting) {
      throw x3::expectation_failure<TokenIterator>(first, std::string(expected::less_nesting));
    }
    return this->subject.parse(first, last, context, rule_context, attribute);
  }
};

template <class Subject>
auto nested(const Subject& subject) {
  return NestedDirective<typename x3::extension::as_parser<Subject>::value_type>(x3::as_parser(subject));
}

}  // namespace mbcc::grammar

// The name in messages of a parser that is made of others is the name of the first of them.
namespace boost::spirit::x3 {
template <class Predicate>
struct get_info<mbcc::grammar::TokenParser<Predicate>> {
  using result_type = std::string;
  std::string operator()(const mbcc::grammar::TokenParser<Predicate>& parser) const {
    return std::string(parser.expected);
  }
};
template <class Parser>
struct get_info<Parser, std::enable_if_t<std::is_same_v<typename Parser::category, unary_category>>> {
  using result_type = std::string;
  std::string operator()(const Parser& parser) const { return what(parser.subject); }
};
template <class Parser>
struct get_info<Parser, std::enable_if_t<std::is_same_v<typename Parser::category, binary_category>>> {
  using result_type = std::string;
  std::string operator()(const Parser& parser) const { return what(parser.left); }
};
}  // namespace boost::spirit::x3
