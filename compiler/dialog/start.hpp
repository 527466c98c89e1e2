#pragma once
// Taking a consistent start over into a draft.

#include <string>
#include <vector>

#include "dialog/draft.hpp"
#include "dialog/workshop.hpp"

namespace mbcc::dialog {

/// Whether everything that moves is asked for, so that the draft can say where it goes.
bool can_take(const Draft& draft, const std::vector<Moved>& start);

/// Gives what moves its value; what stays keeps its text.
void take_start(Draft& draft, const std::vector<Moved>& start);

/// A line for everything that moves.
std::string describe_moves(const std::vector<Moved>& start);

}  // namespace mbcc::dialog
