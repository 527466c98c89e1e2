#include "dialog/draft.hpp"

#include <algorithm>
#include <charconv>

#include "diagnostics/assert.hpp"

namespace mbcc::dialog {

namespace {

/// For a draft and a constant one.
template <class AnyDraft>
auto& quantity_in(AnyDraft& draft, Slot slot) {
  auto& particle = draft.particles[slot.index];
  switch (slot.item) {
    case Item::Position:
      return particle.position;
    case Item::Velocity:
      return particle.velocity;
    default:
      MBCC_ASSERT(slot.item == Item::Force);
      return particle.force;
  }
}

template <class AnyDraft>
auto& answer_in(AnyDraft& draft, Slot slot) {
  switch (slot.item) {
    case Item::Name:
      return draft.name;
    case Item::Dimension:
      return draft.dimension;
    case Item::ParticleCount:
      return draft.particle_count;
    case Item::EquationCount:
      return draft.equation_count;
    case Item::Mass:
      return draft.particles[slot.index].mass;
    case Item::Equation:
      return draft.equations[slot.index];
    case Item::Step:
      return draft.step;
    case Item::From:
      return draft.from;
    case Item::To:
      return draft.to;
    default:
      return quantity_in(draft, slot).components[slot.axis];
  }
}

}  // namespace

std::string& answer(Draft& draft, Slot slot) { return answer_in(draft, slot); }
const std::string& answer(const Draft& draft, Slot slot) { return answer_in(draft, slot); }

Quantity& quantity(Draft& draft, Slot slot) { return quantity_in(draft, slot); }
const Quantity& quantity(const Draft& draft, Slot slot) { return quantity_in(draft, slot); }

std::optional<std::size_t> natural(const std::string& text) {
  std::size_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, failure] = std::from_chars(text.data(), end, value);
  return failure == std::errc() && stopped == end ? std::optional(value) : std::nullopt;
}

std::size_t axes(const Draft& draft) {
  const std::size_t dimension = natural(draft.dimension).value_or(3);
  return dimension == 1 || dimension == 2 ? dimension : 3;
}

std::size_t particles(const Draft& draft) { return natural(draft.particle_count).value_or(0); }
std::size_t equations(const Draft& draft) { return natural(draft.equation_count).value_or(0); }

void make_room(Draft& draft) {
  std::size_t last = 0;
  for (const Particle& particle : draft.particles) {
    last = std::max(last, natural(particle.name).value_or(0));
  }
  while (draft.particles.size() < particles(draft)) {
    draft.particles.push_back({std::to_string(++last), "", {}, {}, {}});
  }
  draft.equations.resize(std::max(draft.equations.size(), equations(draft)));
}

}  // namespace mbcc::dialog
