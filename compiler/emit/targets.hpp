#pragma once
// Where stores go in emitted code.

#include <string_view>

#include "program/program.hpp"

namespace mbcc::cpp {

/// The array that a store writes. The energy has none: it is returned.
std::string_view array_of(program::Target target);

}  // namespace mbcc::cpp
