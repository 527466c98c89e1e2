#pragma once
// The structure of a model as `mbcc check` shows it.

#include <string>

#include "driver/compile.hpp"

namespace mbcc {

/// Coordinates, speeds, degrees of freedom, constraints by kind, rank and redundancy at the start, islands with what
/// joins them, and the operations of one evaluation. The compilation must have reached Stage::Program.
std::string print_structure(const Compilation& compilation);

}  // namespace mbcc
