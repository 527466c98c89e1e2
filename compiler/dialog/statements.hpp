#pragma once
// The answers of a draft as statements of a model, and their parts.

#include <optional>

#include "dialog/draft.hpp"
#include "dialog/item.hpp"
#include "dialog/piece.hpp"

namespace mbcc::dialog {

/// What stands before the `:` of an equation; empty if it has no name.
std::string_view name_of_equation(std::string_view equation);

/// Writes what has been answered, or the implied value of what has not. The `wanted` answer is marked.
class Statements {
 public:
  /// `draft` must outlive the statements.
  Statements(const Draft& draft, std::optional<Slot> wanted) : draft_(draft), wanted_(wanted) {}

  bool is_wanted(Slot slot) const { return slot == wanted_; }

  Piece answered(Slot slot) const;

  /// A field of a particle: its mass, or a vector of components.
  Piece value(Slot field) const;
  bool is_value_wanted(Slot field) const;
  /// Whether a field says more than its absence would.
  bool is_told(Slot field) const;

  Piece particle(std::size_t index) const;

  /// Names are padded to `name_width` at least.
  Piece constraint(std::size_t index, std::size_t name_width) const;

 private:
  const Draft& draft_;
  std::optional<Slot> wanted_;
};

}  // namespace mbcc::dialog
