#pragma once
// What the parser says about text that does not follow the grammar, and where it goes on after it.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "syntax/token.hpp"

namespace mbcc {

/// What the grammar can miss, in the user's words; those that choose a wording of their own have a name here.
namespace expected {
inline constexpr std::string_view statement = "a statement";
inline constexpr std::string_view name = "a name";
inline constexpr std::string_view name_or_number = "a name or a particle's number";
inline constexpr std::string_view comparison = "an operator or a comparison";
inline constexpr std::string_view field_or_end = "a field or `}`";
inline constexpr std::string_view less_nesting = "less nesting";
inline constexpr std::string_view fewer_operators = "fewer operators";
}  // namespace expected

/// Brackets and blocks inside one another. More would endanger the stack, and no reader's head holds them either.
inline constexpr std::size_t max_nesting = 200;

using TokenIterator = TokenBuffer::const_iterator;

class SyntaxErrors {
 public:
  /// Errors that `diagnostics` already holds are the lexer's.
  SyntaxErrors(const TokenBuffer& tokens, Diagnostics& diagnostics);

  /// Reports that the statement or field that begins at `start` should have had `what` at `where`, unless the lexer
  /// already refused a part of it. Returns where parsing goes on: at a separator, `}` or the end of the file.
  TokenIterator report(TokenIterator start, TokenIterator where, std::string_view what);

  void unmatched_brace(const Token& brace);
  void number_out_of_range(const Token& number);

 private:
  void describe_failure(TokenIterator start, TokenIterator where, std::string_view what);
  void expected_statement(TokenIterator where);
  void misplaced_comparison(TokenIterator start, TokenIterator where);
  void expected_something(TokenIterator where, std::string_view what);
  TokenIterator after(TokenIterator start, TokenIterator where) const;
  TokenIterator innermost_opening(TokenIterator where) const;
  bool lexer_refused(TokenIterator start, TokenIterator end) const;

  TokenIterator first_;
  Diagnostics& diagnostics_;
  std::vector<std::uint32_t> refused_;  ///< where the lexer found errors, ascending
  std::optional<std::uint32_t> last_failure_;
};

}  // namespace mbcc
