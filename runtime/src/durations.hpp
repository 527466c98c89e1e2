#pragma once
// Spans of wall time in words.

#include <string>

namespace mbrt {

/// "0.522 ms", "1.25 s", "3 min 5 s", "2 h 3 min".
std::string duration(double seconds);

}  // namespace mbrt
