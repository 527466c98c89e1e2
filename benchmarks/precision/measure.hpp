#pragma once
// Run time against true error.

#include <string>
#include <vector>

#include "precision/contender.hpp"
#include "precision/problems.hpp"

namespace bench::precision {

struct Effort {
  int samples;      ///< at most
  double patience;  ///< seconds: a contender whose run takes longer is not asked for more
};

struct Point {
  std::string contender;
  double setting;
  double seconds;  ///< the least
  double error;    ///< the largest of what the problem watches, at the end
};

/// All contenders at all settings, in turn and again and again, so that what slows the machine slows all of them.
std::vector<Point> measure(const std::vector<Contender>& contenders, const Problem& problem, Effort effort);

}  // namespace bench::precision
