#pragma once
// Pieces of model text on one line.

#include <string>
#include <string_view>

namespace mbcc {

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// Without comments, every run of blanks and line ends as one space.
std::string one_line(std::string_view text);

}  // namespace mbcc
