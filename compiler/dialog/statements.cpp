#include "dialog/statements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "source/text.hpp"

namespace mbcc::dialog {

std::string_view name_of_equation(std::string_view equation) {
  const std::size_t colon = equation.find(':');
  return colon == std::string_view::npos ? "" : trimmed(equation.substr(0, colon));
}

Piece Statements::answered(Slot slot) const {
  const std::string& typed = answer(draft_, slot);
  const std::string_view text = typed.empty() ? row_of(slot.item).implied : typed;
  return is_wanted(slot) ? Piece::marked(text) : Piece(text);
}

Piece Statements::value(Slot field) const {
  if (field.item == Item::Mass || component_count(draft_, field) == 1) {
    return answered(field);
  }
  Piece text = "(";
  for (field.axis = 0; field.axis < component_count(draft_, field); ++field.axis) {
    text += field.axis == 0 ? "" : ", ";
    text += answered(field);
  }
  return text + ")";
}

bool Statements::is_value_wanted(Slot field) const {
  return wanted_ && wanted_->item == field.item && wanted_->index == field.index;
}

bool Statements::is_told(Slot field) const {
  if (field.item == Item::Mass || field.item == Item::Position || is_value_wanted(field)) {
    return true;
  }
  for (field.axis = 0; field.axis < component_count(draft_, field); ++field.axis) {
    const std::string& typed = answer(draft_, field);
    if (!typed.empty() && typed != row_of(field.item).implied) {
      return true;
    }
  }
  return false;
}

Piece Statements::particle(std::size_t index) const {
  Piece text = "particle " + draft_.particles[index].name + " {\n";
  for (const Item item : particle_fields) {
    if (is_told({item, index})) {
      text += fmt::format("  {:8} = ", field_name(item));
      text += value({item, index}) + "\n";
    }
  }
  return text + "}";
}

Piece Statements::constraint(std::size_t index, std::size_t name_width) const {
  const Slot slot{Item::Equation, index};
  const std::string& typed = answer(draft_, slot);
  const std::string_view name = name_of_equation(typed);
  if (is_wanted(slot)) {
    return (name.empty() ? "constraint : " : "constraint ") + answered(slot);
  }
  const std::string_view equation = name.empty() ? typed : trimmed(std::string_view(typed).substr(typed.find(':') + 1));
  const std::size_t width = std::max(name_width, name.size());
  return fmt::format("constraint {:{}}: {}", name, width == 0 ? 0 : width + 1, equation);
}

}  // namespace mbcc::dialog
