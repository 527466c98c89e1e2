#pragma once
// A draft as a model text.

#include <optional>
#include <string>

#include "dialog/draft.hpp"
#include "source/source.hpp"

namespace mbcc::dialog {

struct WrittenModel {
  std::string text;
  Span wanted;  ///< where the answer that was asked for stands
};

/// The model as a person would write it. In one that the dialog started from, only what was answered otherwise changes:
/// comments, order and all that is not asked for stay. What is not answered yet has its implied value or is left out;
/// the `wanted` answer is always written.
WrittenModel write_model(const Draft& draft, std::optional<Slot> wanted = std::nullopt);

}  // namespace mbcc::dialog
