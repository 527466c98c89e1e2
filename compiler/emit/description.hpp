#pragma once
// The static tables of an emitted class: mbrt::Description as C++ text.

#include <string>

#include "model/system.hpp"
#include "program/program.hpp"
#include "source/source.hpp"

namespace mbcc::cpp {

std::string write_description(const program::Program& program, const model::System& system, const Sources& sources);

/// `text` as a C++ string literal.
std::string quote(std::string_view text);

}  // namespace mbcc::cpp
