#pragma once
// Signs that people bring from paper and from other languages, and what to write in a model instead.

#include <string_view>

namespace mbcc {

struct ForeignSign {
  std::string_view sign;
  std::string_view advice;
  bool begins_comment = false;  ///< what follows it on its line was not meant for mbcc
};

/// The sign of the table that `text` begins with, or null.
const ForeignSign* find_foreign_sign(std::string_view text);

}  // namespace mbcc
