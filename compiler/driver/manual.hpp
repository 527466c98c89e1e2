#pragma once
// mbcc(1).

#include <string>

namespace mbcc {

/// The manual page for `man`, with a section for each topic of help.
std::string manual_page();

}  // namespace mbcc
