#pragma once
// Whether a scene that grows costs what it needs and not more.

#include <string>
#include <vector>

#include "measure.hpp"

namespace bench {

struct Growth {
  std::string what;
  double ratio;  ///< of the grown scene's cost to that of its parts
  double limit;
};

/// Emitted code alone; empty where this build has no mbcc.
std::vector<Growth> growth(Effort effort);

void print(const std::vector<Growth>& growths);

}  // namespace bench
