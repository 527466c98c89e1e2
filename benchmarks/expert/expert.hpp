#pragma once
// Code that an expert writes by hand for one model: what emitted code is measured against.

#include <string_view>

#include "contender.hpp"

namespace bench::expert {

/// The expert's program for a model of this name; one exists for each scene in scene.hpp.
Contender contender(std::string_view model);

}  // namespace bench::expert
