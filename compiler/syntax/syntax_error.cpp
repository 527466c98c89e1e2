#include "syntax/syntax_error.hpp"

#include <algorithm>

#include "diagnostics/spelling.hpp"
#include "syntax/ast.hpp"

namespace mbcc {
namespace {

const std::vector<std::string_view>& statement_words() {
  static const std::vector<std::string_view> words = {
#define MBCC_WORD(name, spelling) spelling,
#define MBCC_LATER_WORD(spelling) spelling,
#include "syntax/tokens.def"
  };
  return words;
}

std::string found(const Token& token) {
  if (token.text.empty()) {
    return token.kind == TokenKind::EndOfFile ? "the end of the file" : "the end of the line";
  }
  return fmt::format("`{}`", token.text);
}

bool is_arithmetic(TokenKind kind) {
  return kind == TokenKind::Plus || kind == TokenKind::Minus || kind == TokenKind::Star || kind == TokenKind::Slash ||
         kind == TokenKind::Caret;
}

bool opens(TokenKind kind) {
  return kind == TokenKind::ParenLeft || kind == TokenKind::BracketLeft || kind == TokenKind::BraceLeft;
}
bool closes(TokenKind kind) {
  return kind == TokenKind::ParenRight || kind == TokenKind::BracketRight || kind == TokenKind::BraceRight;
}

bool names_a_closing_bracket(std::string_view what) {
  const std::string_view end = what.substr(what.size() - std::min<std::size_t>(what.size(), 3));
  return end == "`)`" || end == "`]`" || end == "`}`";
}

}  // namespace

SyntaxErrors::SyntaxErrors(const TokenBuffer& tokens, Diagnostics& diagnostics)
    : first_(tokens.begin()), diagnostics_(diagnostics) {
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    if (diagnostic.severity == Severity::Error && diagnostic.span.file == tokens.front().span.file) {
      refused_.push_back(diagnostic.span.begin);
    }
  }
  std::sort(refused_.begin(), refused_.end());
}

void SyntaxErrors::unmatched_brace(const Token& brace) { diagnostics_.report(Finding::UnmatchedBrace, brace.span); }

void SyntaxErrors::number_out_of_range(const Token& number) {
  diagnostics_.report(Finding::NumberOutOfRange, number.span, number.text);
}

TokenIterator SyntaxErrors::report(TokenIterator start, TokenIterator where, std::string_view what) {
  const TokenIterator end = after(start, where);
  const bool reported = last_failure_ == where->span.begin;  // by a block inside, which misses its end here as well
  if (!reported && !lexer_refused(start, end)) {
    describe_failure(start, where, what);
  }
  last_failure_ = where->span.begin;
  return end;
}

void SyntaxErrors::describe_failure(TokenIterator start, TokenIterator where, std::string_view what) {
  if (what == expected::less_nesting) {
    diagnostics_.report(Finding::NestedTooDeep, where->span, max_nesting);
  } else if (what == expected::fewer_operators) {
    diagnostics_.report(Finding::ExpressionTooLong, where->span, ast::max_height);
  } else if (what == expected::statement) {
    expected_statement(where);
  } else if (what == expected::comparison) {
    const Span condition = join(std::next(innermost_opening(where))->span, std::prev(where)->span);
    diagnostics_.report(Finding::ConditionExpected, condition);
  } else if ((what == expected::name || what == expected::name_or_number) && is_reserved(where->kind)) {
    diagnostics_.report(Finding::ReservedWord, where->span, where->text);
  } else if (is_comparison(where->kind)) {
    misplaced_comparison(start, where);
  } else {
    expected_something(where, what);
  }
}

void SyntaxErrors::expected_statement(TokenIterator where) {
  const bool begins_line = where == first_ || std::prev(where)->kind == TokenKind::Separator;
  if (where->kind == TokenKind::Name) {
    std::string guess = suggestion(where->text, statement_words());
    if (guess.empty() && std::next(where)->kind == TokenKind::Equal) {
      guess = fmt::format("; did you mean `let {} = ...`?", where->text);
    }
    diagnostics_.report(Finding::UnknownStatement, where->span, where->text, guess);
  } else if (begins_line && is_arithmetic(where->kind)) {
    diagnostics_.report(Finding::LineBeginsWithOperator, where->span, where->text);
  } else {
    expected_something(where, expected::statement);
  }
}

void SyntaxErrors::misplaced_comparison(TokenIterator start, TokenIterator where) {
  if (start->kind != TokenKind::Constraint) {
    diagnostics_.report(Finding::ComparisonOutsideIf, where->span);
  } else if (where->kind == TokenKind::EqualEqual) {
    diagnostics_.report(Finding::EqualsSign, where->span);
  } else {
    diagnostics_.report(Finding::Inequality, where->span);
  }
}

void SyntaxErrors::expected_something(TokenIterator where, std::string_view what) {
  Diagnostic& diagnostic = diagnostics_.report(Finding::Expected, where->span, what, found(*where));
  if (names_a_closing_bracket(what)) {
    const Token& opening = *innermost_opening(where);
    diagnostic.note(opening.span, fmt::format("`{}` opens here", opening.text));
  }
}

/// Behind the bad statement or field, with every block that it opens after `where`. If the text looks as if the next
/// statement had begun, a forgotten `}` say, then there.
TokenIterator SyntaxErrors::after(TokenIterator start, TokenIterator where) const {
  if (where != start && begins_statement(where->kind) && std::prev(where)->kind == TokenKind::Separator) {
    return std::prev(where);
  }
  std::size_t open = 0;
  for (TokenIterator at = where;; ++at) {
    const bool ends_here = at->kind == TokenKind::Separator || at->kind == TokenKind::BraceRight;
    if (at->kind == TokenKind::EndOfFile || (open == 0 && ends_here)) {
      return at;
    }
    open += at->kind == TokenKind::BraceLeft ? 1U : 0U;
    open -= at->kind == TokenKind::BraceRight ? 1U : 0U;
  }
}

/// The last bracket before `where` that no bracket before `where` closes.
TokenIterator SyntaxErrors::innermost_opening(TokenIterator where) const {
  std::size_t closed = 0;
  for (TokenIterator at = std::prev(where); at != first_; --at) {
    if (opens(at->kind) && closed == 0) {
      return at;
    }
    closed += closes(at->kind) ? 1U : 0U;
    closed -= opens(at->kind) ? 1U : 0U;
  }
  return first_;
}

/// Up to the next statement, for the end of a line stands right behind its last token.
bool SyntaxErrors::lexer_refused(TokenIterator start, TokenIterator end) const {
  const auto refused = std::lower_bound(refused_.begin(), refused_.end(), start->span.begin);
  if (refused == refused_.end() || end->kind == TokenKind::EndOfFile) {
    return refused != refused_.end();
  }
  return *refused < (end->text.empty() ? std::next(end) : end)->span.begin;
}

}  // namespace mbcc
