#pragma once
// What someone writes who knows the model, the method and the machine, and the same right-hand sides in Boost.Odeint.

#include <vector>

#include "precision/contender.hpp"
#include "precision/problems.hpp"

namespace bench::precision {

/// None for a problem that nobody has written by hand. `start`: coordinates and then speeds, as declared.
std::vector<Contender> by_hand(const Problem& problem, const std::vector<double>& start);

}  // namespace bench::precision
