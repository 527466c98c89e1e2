#pragma once
// What the rules of the grammar do with the parts that they read. Included by parser.cpp alone.

#include <optional>
#include <string>
#include <utility>

#include "syntax/ast.hpp"
#include "syntax/tree.hpp"
#include "syntax/x3/terminals.hpp"

namespace mbcc::grammar {

template <class Member>
auto into(Member member) {
  return [member](auto& context) { x3::_val(context).*member = std::move(x3::_attr(context)); };
}

template <class Member>
auto append_to(Member member) {
  return [member](auto& context) { (x3::_val(context).*member).push_back(std::move(x3::_attr(context))); };
}

/// The text of a token.
template <class Member>
auto text_into(Member member) {
  return [member](auto& context) { x3::_val(context).*member = std::string(x3::_attr(context).text); };
}

/// The text of a token and its place.
template <class Member, class Place>
auto text_into(Member member, Place place) {
  return [member, place](auto& context) {
    x3::_val(context).*member = std::string(x3::_attr(context).text);
    x3::_val(context).*place = x3::_attr(context).span;
  };
}

/// What `function` makes of a token.
template <class Member, class Function>
auto made_into(Member member, Function function) {
  return [member, function](auto& context) { x3::_val(context).*member = function(x3::_attr(context)); };
}

inline const auto take = [](auto& context) { x3::_val(context) = std::move(x3::_attr(context)); };
inline const auto append = [](auto& context) { x3::_val(context).push_back(std::move(x3::_attr(context))); };

/// A statement or field that failed left its tree without a span.
inline bool is_finished(const ast::Statement& statement) { return statement.span != Span{}; }
inline bool is_finished(const ast::Field& field) { return field.value.span != Span{}; }
inline const auto append_finished = [](auto& context) {
  if (is_finished(x3::_attr(context))) {
    x3::_val(context).push_back(std::move(x3::_attr(context)));
  }
};

/// Statements between two unmatched braces.
inline const auto append_statements = [](auto& context) {
  for (ast::Statement& statement : x3::_attr(context)) {
    x3::_val(context).statements.push_back(std::move(statement));
  }
};

/// Keeps trees within the height that every pass can walk.
inline void check_height(std::size_t height, TokenIterator where) {
  if (height > ast::max_height) {
    throw x3::expectation_failure<TokenIterator>(where, std::string(expected::fewer_operators));
  }
}
template <class Context>
void check_height(const Context& context) {
  check_height(x3::_val(context).height, x3::_where(context).begin());
}

inline const auto take_node = [](auto& context) { x3::_val(context).node = std::move(x3::_attr(context)); };
inline const auto take_parentheses = [](auto& context) {
  x3::_val(context).node = tree::parentheses(std::move(x3::_attr(context)));
};

/// Left-associative: what was read so far becomes the left operand.
inline const auto combine = [](auto& context) {
  using boost::fusion::at_c;
  auto& parts = x3::_attr(context);
  x3::_val(context) = tree::binary(std::move(x3::_val(context)), at_c<0>(parts), std::move(at_c<1>(parts)));
  check_height(context);
};

inline const auto apply_signs = [](auto& context) {
  using boost::fusion::at_c;
  auto& parts = x3::_attr(context);
  check_height(at_c<0>(parts).size() + at_c<1>(parts).height, x3::_where(context).begin());
  x3::_val(context) = tree::with_signs(at_c<0>(parts), std::move(at_c<1>(parts)));
};

inline const auto apply_prime = [](auto& context) {
  x3::_val(context) = tree::rate(std::move(x3::_val(context)), x3::_attr(context));
  check_height(context);
};

template <class Context>
ast::Number read_number(const Context& context) {
  const Token& token = x3::_attr(context);
  const std::optional<ast::Number> number = tree::number(token);
  if (!number) {
    state(context).errors.number_out_of_range(token);
  }
  return number.value_or(ast::Number{});
}

inline const auto take_number = [](auto& context) { x3::_val(context).node = read_number(context); };

inline const auto compare = [](auto& context) {
  using boost::fusion::at_c;
  auto& parts = x3::_attr(context);
  x3::_val(context) = tree::comparison(std::move(x3::_val(context)), at_c<0>(parts), std::move(at_c<1>(parts)));
};

inline const auto take_particle_number = [](auto& context) { x3::_val(context).number = read_number(context).value; };

inline const auto take_path = [](auto& context) {
  x3::_val(context).path = tree::unquoted(x3::_attr(context));
  x3::_val(context).path_span = x3::_attr(context).span;
};

inline const auto unmatched_brace = [](auto& context) { state(context).errors.unmatched_brace(x3::_attr(context)); };

/// Notes where a tree stands: from token `first` to the one before `last`.
template <class Tree>
void place(Tree& tree, TokenIterator first, TokenIterator last) {
  tree.span = join(first->span, std::prev(last)->span);
}
inline void place(ast::Expression& tree, TokenIterator first, TokenIterator last) {
  tree = tree::expression(join(first->span, std::prev(last)->span), std::move(tree.node));
  check_height(tree.height, last);
}
inline void place(ast::Statement& tree, TokenIterator first, TokenIterator last) {
  tree.span = join(first->span, std::prev(last)->span);
  tree.keyword_span = first->span;
}

/// Its subject, with which the tree of the rule is complete and gets its place.
template <class Subject>
struct PlacedDirective : x3::unary_parser<Subject, PlacedDirective<Subject>> {
  static constexpr bool is_pass_through_unary = true;
  using x3::unary_parser<Subject, PlacedDirective<Subject>>::unary_parser;

  template <class Context, class Tree, class Attribute>
  bool parse(TokenIterator& first, const TokenIterator& last, const Context& context, Tree& tree,
             Attribute& attribute) const {
    const TokenIterator start = first;
    if (!this->subject.parse(first, last, context, tree, attribute)) {
      return false;
    }
    place(tree, start, first);
    return true;
  }
};

template <class Subject>
auto placed(const Subject& subject) {
  return PlacedDirective<typename x3::extension::as_parser<Subject>::value_type>(x3::as_parser(subject));
}

/// Its subject, behind which the parse goes on where it fails. X3's own on_error does not do: some versions of Boost
/// (1.74) tell it where the subject began, others (1.81) how far it came.
template <class Subject>
struct RecoveringDirective : x3::unary_parser<Subject, RecoveringDirective<Subject>> {
  static constexpr bool is_pass_through_unary = true;
  using x3::unary_parser<Subject, RecoveringDirective<Subject>>::unary_parser;

  template <class Context, class Tree, class Attribute>
  bool parse(TokenIterator& first, const TokenIterator& last, const Context& context, Tree& tree,
             Attribute& attribute) const {
    const TokenIterator start = first;
    try {
      return this->subject.parse(first, last, context, tree, attribute);
    } catch (const x3::expectation_failure<TokenIterator>& failure) {
      first = state(context).errors.report(start, failure.where(), failure.which());
      return true;
    }
  }
};

template <class Subject>
auto recovering(const Subject& subject) {
  return RecoveringDirective<typename x3::extension::as_parser<Subject>::value_type>(x3::as_parser(subject));
}

}  // namespace mbcc::grammar
