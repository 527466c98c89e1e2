#pragma once
// What is allowed but looks like a mistake.

#include <vector>

#include "model/context.hpp"

namespace mbcc::model {

/// Parameters and `let`s that nothing uses.
void warn_of_unused(Context& context);

/// `a^b^c` without parentheses.
void warn_of_powers(const std::vector<const ast::Statement*>& statements, Context& context);

}  // namespace mbcc::model
