#include "dialog/item.hpp"

#include <fmt/format.h>

#include "diagnostics/assert.hpp"
#include "model/names.hpp"

namespace mbcc::dialog {

namespace {

void add_particles(std::vector<Slot>& slots, Item item, const Draft& draft, std::size_t index) {
  const std::size_t count = item == Item::Mass ? 1 : component_count(draft, {item, index});
  for (std::size_t axis = 0; axis < count; ++axis) {
    slots.push_back({item, index, axis});
  }
}

/// m1, fx1, vx1, x1, and bob.m, bob.fx.
std::string symbol(const Particle& particle, std::string_view prefix, std::string_view axis) {
  return natural(particle.name) ? fmt::format("{}{}{}", prefix, axis, particle.name)
                                : fmt::format("{}.{}{}", particle.name, prefix, axis);
}

}  // namespace

std::string_view field_name(Item item) {
  switch (item) {
    case Item::Mass:
      return "mass";
    case Item::Position:
      return "position";
    case Item::Velocity:
      return "velocity";
    case Item::Force:
      return "force";
    case Item::From:
      return "from";
    case Item::To:
      return "to";
    default:
      MBCC_ASSERT(item == Item::Step);
      return "step";
  }
}

std::size_t component_count(const Draft& draft, Slot vector) { return quantity(draft, vector).whole ? 1 : axes(draft); }

std::vector<Slot> slots_of(Dialog dialog, const Draft& draft) {
  std::vector<Slot> slots;
  const auto each_particle = [&](std::initializer_list<Item> items) {
    for (std::size_t i = 0; i < particles(draft); ++i) {
      for (const Item item : items) {
        add_particles(slots, item, draft, i);
      }
    }
  };
  switch (dialog) {
    case Dialog::Name:
      return {{Item::Name}};
    case Dialog::Dimension:
      return {{Item::Dimension}};
    case Dialog::Particles:
      return {{Item::ParticleCount}};
    case Dialog::Equations:
      return {{Item::EquationCount}};
    case Dialog::Masses:
      each_particle({Item::Mass});
      break;
    case Dialog::Forces:
      each_particle({Item::Force});
      break;
    case Dialog::Constraints:
      for (std::size_t i = 0; i < equations(draft); ++i) {
        slots.push_back({Item::Equation, i});
      }
      break;
    case Dialog::Start:
      each_particle({Item::Position, Item::Velocity});
      break;
    case Dialog::Times:
      return {{Item::Step}, {Item::From}, {Item::To}};
  }
  return slots;
}

std::string variable(const Particle& particle, Item item, std::size_t axis) {
  const std::string_view prefix = item == Item::Velocity ? "v" : item == Item::Force ? "f" : "";
  return symbol(particle, prefix, model::axis_names[axis]);
}

std::string label(const Draft& draft, Slot slot) {
  switch (slot.item) {
    case Item::Name:
      return "name";
    case Item::Dimension:
      return "dimension";
    case Item::ParticleCount:
      return "particles";
    case Item::EquationCount:
      return "constraints";
    case Item::Mass:
      return symbol(draft.particles[slot.index], "m", "");
    case Item::Equation:
      return fmt::format("g{}", slot.index + 1);
    case Item::Step:
      return "step";
    case Item::From:
      return "initial time";
    case Item::To:
      return "final time";
    case Item::Position:
    case Item::Velocity:
    case Item::Force:
      break;
  }
  const Particle& particle = draft.particles[slot.index];
  return quantity(draft, slot).whole ? fmt::format("{} of {}", field_name(slot.item), particle.name)
                                     : variable(particle, slot.item, slot.axis);
}

std::string prefill(const Draft& draft, Slot slot) {
  const std::string& typed = answer(draft, slot);
  const ItemRow& row = row_of(slot.item);
  return typed.empty() ? std::string(draft.base.empty() ? row.prefill : row.implied) : typed;
}

}  // namespace mbcc::dialog
