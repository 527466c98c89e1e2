#pragma once
// Where stores go in emitted code, and what solves islands where the plain way is not safe.

#include <string_view>

#include "program/program.hpp"

namespace mbcc::cpp {

/// The array that a store writes. The energy has none: it is returned.
std::string_view array_of(program::Target target);

/// The member function, but for the number of the island, that finds such unknowns where the plain solve is not safe.
std::string_view climb_of(program::Unknowns unknowns);

}  // namespace mbcc::cpp
