#pragma once
// The generic way: dense dual numbers and a pseudo-inverse, by rk4 and by dop853.

#include <vector>

#include "precision/contender.hpp"
#include "precision/problems.hpp"

namespace bench::precision {

/// None for a scene that is not written for it, or is so large that one evaluation takes milliseconds.
std::vector<Contender> by_pinv(const Problem& problem, const std::vector<double>& start);

}  // namespace bench::precision
