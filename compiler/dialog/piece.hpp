#pragma once
// Text that knows where in it the answer stands that its reader looks for.

#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "source/source.hpp"

namespace mbcc::dialog {

class Piece {
 public:
  Piece() = default;
  template <class Text>
  requires std::constructible_from<std::string, Text> Piece(const Text& text) : text_(text) {}  // plain text is a piece

  /// The answer.
  static Piece marked(std::string_view text) {
    Piece piece(text);
    piece.mark_ = Span{0, 0, static_cast<std::uint32_t>(text.size())};
    return piece;
  }

  Piece& operator+=(const Piece& other) {
    const auto shift = static_cast<std::uint32_t>(text_.size());
    if (other.mark_) {
      mark_ = Span{0, other.mark_->begin + shift, other.mark_->end + shift};
    }
    text_ += other.text_;
    return *this;
  }
  friend Piece operator+(Piece left, const Piece& right) { return left += right; }

  const std::string& text() const { return text_; }
  const std::optional<Span>& mark() const { return mark_; }

 private:
  std::string text_;
  std::optional<Span> mark_;
};

}  // namespace mbcc::dialog
