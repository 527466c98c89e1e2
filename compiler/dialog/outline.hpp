#pragma once
// A model text seen as a draft: what it answers already, and where.

#include <optional>
#include <string_view>
#include <vector>

#include "dialog/draft.hpp"
#include "source/source.hpp"

namespace mbcc::dialog {

struct BlockPlaces {
  Span statement;
  std::optional<std::uint32_t> end_of_fields;  ///< where another one may follow; nothing if there is none
  bool one_line = false;                       ///< the last field and the end of the block
};

struct ParticlePlaces {
  BlockPlaces block;
  std::optional<Span> mass, position, velocity, force;  ///< their values
};

struct EquationPlaces {
  Span statement;
  Span answer;  ///< with the name, if there is one
};

/// The particles, constraints and times that stand by themselves; what is in loops or imported is not asked for. Spans
/// are those of the text, which must follow the grammar.
struct Outline {
  Draft answers;
  std::optional<Span> name, dimension, step, from, to;
  std::vector<ParticlePlaces> particles;
  std::vector<EquationPlaces> equations;
  std::optional<BlockPlaces> integrate;
  std::uint32_t first_statement = 0;  ///< where its line begins; behind the text if there is none
};

/// `name` is the system's if the text does not say another.
Outline outline(std::string_view text, std::string_view name);

}  // namespace mbcc::dialog
