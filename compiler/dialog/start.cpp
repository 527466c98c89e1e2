#include "dialog/start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dialog/item.hpp"

namespace mbcc::dialog {

namespace {

/// By more than rounding.
bool moves(const Moved& moved) { return std::abs(moved.to - moved.from) > 1e-12 * std::max(1.0, std::abs(moved.to)); }

/// All digits but those that are rounding.
std::string shown(double value) { return fmt::format("{:.15g}", value); }

/// Calls `visit(slot, moved)` for each component at the start that `start` knows.
template <class Visit>
void for_each_component(const Draft& draft, const std::vector<Moved>& start, const Visit& visit) {
  std::map<std::string, const Moved*> by_name;
  for (const Moved& moved : start) {
    by_name.emplace(moved.name, &moved);
  }
  for (std::size_t i = 0; i < particles(draft); ++i) {
    for (const Item item : {Item::Position, Item::Velocity}) {
      for (std::size_t axis = 0; axis < axes(draft); ++axis) {
        const auto found = by_name.find(variable(draft.particles[i], item, axis));
        if (found != by_name.end()) {
          visit(Slot{item, i, axis}, *found->second);
        }
      }
    }
  }
}

}  // namespace

bool can_take(const Draft& draft, const std::vector<Moved>& start) {
  std::ptrdiff_t taken = 0;
  for_each_component(draft, start, [&](Slot, const Moved& moved) { taken += moves(moved) ? 1 : 0; });
  return taken > 0 && taken == std::count_if(start.begin(), start.end(), moves);
}

void take_start(Draft& draft, const std::vector<Moved>& start) {
  const Draft before = draft;
  for_each_component(before, start, [&](Slot slot, const Moved& moved) {
    const bool was_whole = quantity(before, slot).whole;
    if (was_whole || moves(moved)) {
      answer(draft, slot) = shown(moved.to);
      quantity(draft, slot).whole = false;
    }
  });
}

std::string describe_moves(const std::vector<Moved>& start) {
  std::string lines;
  for (const Moved& moved : start) {
    lines +=
        moves(moved) ? fmt::format("  {} = {} instead of {}\n", moved.name, shown(moved.to), shown(moved.from)) : "";
  }
  return lines;
}

}  // namespace mbcc::dialog
