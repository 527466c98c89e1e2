#pragma once
// The tables of dialogs.def, and which answers a dialog asks for.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "dialog/draft.hpp"

namespace mbcc::dialog {

/// How an answer is checked.
enum class Check : std::uint8_t { Name, Dimension, Particles, Equations, Expression, Equation };

struct DialogRow {
  char letter;
  bool confirmed;
};

struct ItemRow {
  Dialog dialog;
  Check check;
  std::string_view prefill;
  std::string_view implied;
  std::string_view help;
};

inline constexpr std::array dialog_table = {
#define MBCC_DIALOG(name, letter, confirmed) DialogRow{letter, confirmed},
#include "dialog/dialogs.def"
};

inline constexpr std::array item_table = {
#define MBCC_ITEM(name, dialog, check, prefill, implied, help) \
  ItemRow{Dialog::dialog, Check::check, prefill, implied, help},
#include "dialog/dialogs.def"
};

constexpr const DialogRow& row_of(Dialog dialog) { return dialog_table[static_cast<std::size_t>(dialog)]; }
constexpr const ItemRow& row_of(Item item) { return item_table[static_cast<std::size_t>(item)]; }

/// In the order in which a model gives them.
inline constexpr std::array particle_fields = {Item::Mass, Item::Position, Item::Velocity, Item::Force};
inline constexpr std::array time_fields = {Item::From, Item::To, Item::Step};

/// As a model calls it: "mass", "from".
std::string_view field_name(Item item);

/// How many answers make the vector that a component belongs to.
std::size_t component_count(const Draft& draft, Slot vector);

/// What `dialog` asks for, in order.
std::vector<Slot> slots_of(Dialog dialog, const Draft& draft);

/// What a model calls a coordinate or speed: "x1", "bob.vx". A force is called likewise: "fx1", "bob.fx".
std::string variable(const Particle& particle, Item item, std::size_t axis);

/// The short name of an answer: "m1", "vx1", "position of bob", "g2", "step".
std::string label(const Draft& draft, Slot slot);

/// What stands in the line when the question is asked: the answer, or what ENTER may accept instead of one. A model
/// that exists says what it implies.
std::string prefill(const Draft& draft, Slot slot);

}  // namespace mbcc::dialog
