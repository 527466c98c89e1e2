#pragma once
// Changes of a text, made all at once.

#include <string>
#include <vector>

#include "dialog/piece.hpp"

namespace mbcc::dialog {

class Revision {
 public:
  /// Spans are those of `text`, which must outlive the revision.
  explicit Revision(std::string_view text) : text_(text) {}

  /// Changes must not overlap.
  void replace(Span span, Piece piece) { changes_.push_back({span, std::move(piece)}); }

  /// Of two insertions at one place the first comes first.
  void insert(std::uint32_t place, Piece piece) { replace({0, place, place}, std::move(piece)); }
  void append(Piece piece) { insert(static_cast<std::uint32_t>(text_.size()), std::move(piece)); }

  /// The statement with its indentation, the comment behind it and the line's end, unless other statements share its
  /// lines.
  Span lines_of(Span statement) const;

  Piece result();

 private:
  struct Change {
    Span span;
    Piece piece;
  };

  std::string_view text_;
  std::vector<Change> changes_;
};

}  // namespace mbcc::dialog
