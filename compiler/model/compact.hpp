#pragma once
// Leaves out of a System the expressions that nothing in it uses.

#include "model/system.hpp"

namespace mbcc::model {

/// Keeps the order of those that stay.
void compact(System& system);

}  // namespace mbcc::model
