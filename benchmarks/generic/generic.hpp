#pragma once
// The generic way: the textbook's formula evaluated with general libraries, with no knowledge of the model.

#include <optional>
#include <string_view>

#include "contender.hpp"

namespace bench::generic {

/// Nothing for a chain so long that a single evaluation would take seconds.
std::optional<Contender> contender(std::string_view model);

}  // namespace bench::generic
