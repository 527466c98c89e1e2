// Model text to tokens. The rules of line ends are those of grammar/model.ebnf, lexical part.

#include <algorithm>
#include <array>

#include "syntax/foreign_signs.hpp"
#include "syntax/token.hpp"

namespace mbcc {
namespace {

struct Spelling {
  std::string_view text;
  TokenKind kind;
};

constexpr std::array symbols = {
#define MBCC_SYMBOL(name, spelling) Spelling{spelling, TokenKind::name},
#include "syntax/tokens.def"
};

constexpr std::array words = {
#define MBCC_WORD(name, spelling) Spelling{spelling, TokenKind::name},
#define MBCC_LATER_WORD(spelling) Spelling{spelling, TokenKind::LaterWord},
#include "syntax/tokens.def"
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
bool is_printable(char c) { return c > ' ' && c <= '~'; }

/// Bytes of the UTF-8 character at the start of `text`; 0 if there is none.
std::size_t character_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80U ? 1U : lead < 0xC2U ? 0U : lead < 0xE0U ? 2U : lead < 0xF0U ? 3U : 4U;
  if (lead > 0xF4U || text.size() < length) {
    return 0;
  }
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  const std::string_view rest = text.substr(0, length).substr(std::min<std::size_t>(length, 1));
  return std::all_of(rest.begin(), rest.end(), continues) ? length : 0;
}

/// A character as a message can show it: itself, or `\xNN` for what has no shape.
std::string shown(std::string_view character) {
  const bool has_shape = character.size() > 1 || is_printable(character.front());
  return has_shape ? std::string(character)
                   : fmt::format("\\x{:02X}", static_cast<unsigned>(static_cast<unsigned char>(character.front())));
}

/// A line that ends in one of these is unfinished.
bool expects_more(TokenKind kind) {
  switch (kind) {
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Star:
    case TokenKind::Slash:
    case TokenKind::Caret:
    case TokenKind::Comma:
    case TokenKind::Equal:
    case TokenKind::Colon:
    case TokenKind::DotDot:
      return true;
    default:
      return is_comparison(kind);
  }
}

class Lexer {
 public:
  Lexer(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics)
      : file_(file), text_(sources[file].text()), diagnostics_(diagnostics) {}

  TokenBuffer run();

 private:
  std::string_view rest() const { return text_.substr(at_); }
  char peek(std::size_t ahead) const { return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0'; }
  std::size_t to_line_end() const { return std::min(rest().find('\n'), rest().size()); }
  std::size_t count(std::size_t from, bool (*belongs)(char)) const;
  Span span(std::size_t length) const;

  void skip_blanks();
  void scan();
  void scan_word();
  void scan_text();
  void scan_sign();
  void refuse_sign();
  std::size_t number_length() const;
  void emit(TokenKind kind, std::size_t length);
  bool separated_from(TokenKind next) const;

  std::uint32_t file_;
  std::string_view text_;
  Diagnostics& diagnostics_;
  TokenBuffer tokens_;
  std::size_t at_ = 0;
  std::size_t open_brackets_ = 0;
  bool new_line_ = false;
};

std::size_t Lexer::count(std::size_t from, bool (*belongs)(char)) const {
  std::size_t length = 0;
  while (belongs(peek(from + length))) {
    ++length;
  }
  return length;
}

Span Lexer::span(std::size_t length) const {
  return {file_, static_cast<std::uint32_t>(at_), static_cast<std::uint32_t>(at_ + length)};
}

TokenBuffer Lexer::run() {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest().substr(0, byte_order_mark.size()) == byte_order_mark) {
    at_ = byte_order_mark.size();
  }
  for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
    scan();
  }
  const std::uint32_t end = tokens_.empty() ? 0 : tokens_.back().span.end;
  tokens_.push_back({TokenKind::EndOfFile, {file_, end, end}, {}});
  return std::move(tokens_);
}

void Lexer::skip_blanks() {
  while (at_ < text_.size() && (is_blank(text_[at_]) || text_[at_] == '#')) {
    if (text_[at_] == '#') {
      at_ += to_line_end();
    } else {
      new_line_ = new_line_ || text_[at_] == '\n';
      ++at_;
    }
  }
}

void Lexer::scan() {
  if (is_letter(peek(0))) {
    scan_word();
  } else if (const std::size_t length = number_length(); length > 0) {
    emit(count(0, is_digit) == length ? TokenKind::Natural : TokenKind::Real, length);
  } else if (peek(0) == '"') {
    scan_text();
  } else if (peek(0) == ';') {
    emit(TokenKind::Separator, 1);
  } else {
    scan_sign();
  }
}

void Lexer::scan_word() {
  const std::size_t length = count(0, [](char c) { return is_letter(c) || is_digit(c); });
  const std::string_view word = rest().substr(0, length);
  const auto found = std::find_if(words.begin(), words.end(), [word](const Spelling& row) { return row.text == word; });
  emit(found == words.end() ? TokenKind::Name : found->kind, length);
}

/// digits "." digits, either side may be absent, then an exponent. A `.` before a `.` belongs to no number: `1..N`.
std::size_t Lexer::number_length() const {
  const std::size_t whole = count(0, is_digit);
  std::size_t length = whole;
  if (peek(length) == '.' && peek(length + 1) != '.') {
    const std::size_t fraction = count(length + 1, is_digit);
    length += whole + fraction > 0 ? 1 + fraction : 0;
  }
  if (length > 0 && (peek(length) == 'e' || peek(length) == 'E')) {
    const std::size_t sign = peek(length + 1) == '+' || peek(length + 1) == '-' ? 1 : 0;
    const std::size_t exponent = count(length + 1 + sign, is_digit);
    length += exponent > 0 ? 1 + sign + exponent : 0;
  }
  return length;
}

void Lexer::scan_text() {
  const std::size_t end_of_line = to_line_end();
  const std::size_t closing = rest().find('"', 1);
  if (closing < end_of_line) {
    emit(TokenKind::Text, closing + 1);
    return;
  }
  diagnostics_.report(Finding::UnterminatedText, span(1));
  at_ += end_of_line;
}

void Lexer::scan_sign() {
  const auto begins_rest = [this](const Spelling& row) { return rest().substr(0, row.text.size()) == row.text; };
  const auto found = std::find_if(symbols.begin(), symbols.end(), begins_rest);
  const ForeignSign* foreign = find_foreign_sign(rest());
  const bool is_foreign = foreign != nullptr && (found == symbols.end() || foreign->sign.size() > found->text.size());
  if (found != symbols.end() && !is_foreign) {
    emit(found->kind, found->text.size());
  } else if (is_foreign) {
    diagnostics_.report(Finding::ForeignSign, span(foreign->sign.size()), foreign->sign, foreign->advice);
    at_ += foreign->begins_comment ? to_line_end() : foreign->sign.size();
  } else {
    refuse_sign();
  }
}

/// Reports a character, or a whole run of bytes that are no characters at all.
void Lexer::refuse_sign() {
  std::size_t length = character_length(rest());
  if (length > 0) {
    diagnostics_.report(Finding::UnknownSign, span(length), shown(rest().substr(0, length)));
  } else {
    while (at_ + length < text_.size() && character_length(rest().substr(length)) == 0) {
      ++length;
    }
    diagnostics_.report(Finding::NotUtf8, span(length), shown(rest().substr(0, 1)));
  }
  at_ += length;
}

void Lexer::emit(TokenKind kind, std::size_t length) {
  const bool ends_brackets = kind == TokenKind::BraceLeft || kind == TokenKind::BraceRight ||
                             kind == TokenKind::Separator || (new_line_ && begins_statement(kind));
  if (ends_brackets) {
    open_brackets_ = 0;
  }
  if (new_line_ && separated_from(kind)) {
    const std::uint32_t end = tokens_.back().span.end;
    tokens_.push_back({TokenKind::Separator, {file_, end, end}, {}});
  }
  new_line_ = false;
  if (kind == TokenKind::ParenLeft || kind == TokenKind::BracketLeft) {
    ++open_brackets_;
  } else if ((kind == TokenKind::ParenRight || kind == TokenKind::BracketRight) && open_brackets_ > 0) {
    --open_brackets_;
  }
  tokens_.push_back({kind, span(length), rest().substr(0, length)});
  at_ += length;
}

/// Whether the line end before `next` ends a statement. No expression goes on with the word of a statement: even an
/// unfinished line ends before it, and one forgotten bracket does not swallow the rest of the file.
bool Lexer::separated_from(TokenKind next) const {
  if (tokens_.empty() || next == TokenKind::BraceLeft || next == TokenKind::Separator) {
    return false;
  }
  const TokenKind last = tokens_.back().kind;
  if (last == TokenKind::BraceLeft || last == TokenKind::Separator) {
    return false;
  }
  return begins_statement(next) || (open_brackets_ == 0 && !expects_more(last));
}

}  // namespace

TokenBuffer lex(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  return Lexer(sources, file, diagnostics).run();
}

}  // namespace mbcc
