#pragma once
// Is an answer right?

#include <string>

#include "diagnostics/render.hpp"
#include "dialog/draft.hpp"
#include "dialog/workshop.hpp"

namespace mbcc::dialog {

struct Verdict {
  bool accepted = false;
  std::string text;     ///< the answer as it counts
  std::string message;  ///< why not, or a warning; whole lines
};

/// Looks at `typed` as the answer at `slot` of `draft`, by the rules of the language: what the model would be refused
/// for, the answer is refused for, with the same words and a caret under the text.
Verdict check_answer(const Draft& draft, Slot slot, const std::string& typed, const Workshop& workshop,
                     Colours colours);

}  // namespace mbcc::dialog
