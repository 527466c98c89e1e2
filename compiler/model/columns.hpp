#pragma once
// The order in which results show a System's coordinates and speeds.

#include <vector>

#include "model/system.hpp"

namespace mbcc::model {

/// Indices into the state, coordinates first, in order of declaration; empty where the state has that order too.
std::vector<int> columns(const System& system);

}  // namespace mbcc::model
