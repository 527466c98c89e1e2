#pragma once
// Tokens: what the lexer makes of model text. No white space and no comments survive.

#include <cstdint>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "source/source.hpp"

namespace mbcc {

enum class TokenKind : std::uint8_t {
#define MBCC_TOKEN(name, described) name,
#include "syntax/tokens.def"
#undef MBCC_TOKEN
};

inline constexpr std::size_t token_kinds = 0
#define MBCC_TOKEN(name, described) +1
#include "syntax/tokens.def"
    ;

/// The token in the user's words, for messages: "a name", "`)`", "the end of the file".
std::string_view describe(TokenKind kind);
std::string_view name_of(TokenKind kind);  ///< its enumerator, for dumps

bool begins_statement(TokenKind kind);  ///< a word of a statement, now or in a later version
bool is_reserved(TokenKind kind);       ///< a word that no thing can have as its name
bool is_comparison(TokenKind kind);

struct Token {
  TokenKind kind;
  Span span;
  std::string_view text;  ///< into the Source; empty for EndOfFile and line ends
};

/// Ends in exactly one EndOfFile. A line's end that ends a statement is a Separator, as is `;`; the former has no text,
/// and it and EndOfFile stand right behind the token before them.
using TokenBuffer = std::vector<Token>;

/// Never fails: what is no token is reported and skipped.
TokenBuffer lex(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);

}  // namespace mbcc
