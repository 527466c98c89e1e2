#pragma once
// An interrupted dialog, and how it is kept in a file.

#include <optional>
#include <string>

#include "dialog/draft.hpp"

namespace mbcc::dialog {

/// Where the dialogs have got to.
struct Place {
  Dialog dialog = Dialog::Name;
  std::size_t index = 0;    ///< of the question in its dialog
  bool confirming = false;  ///< the question is whether the answers of the dialog are right
};

/// Enough to go on with the dialog.
struct Bookmark {
  Draft draft;
  Place place;
  std::string unfinished;  ///< what stood in the line
};

/// JSON.
std::string write_bookmark(const Bookmark& bookmark);

/// Nothing if `text` is not what write_bookmark writes. The path of the draft is the reader's affair.
std::optional<Bookmark> read_bookmark(const std::string& text);

}  // namespace mbcc::dialog
