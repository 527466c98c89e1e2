#pragma once
// One way to integrate a problem from 0 to its end, at any setting.

#include <functional>
#include <string>
#include <vector>

namespace bench::precision {

struct Contender {
  std::string name;
  std::vector<double> settings;  ///< from coarse to fine: tolerances, or numbers of steps
  /// What the problem watches, at the end.
  std::function<std::vector<double>(double setting)> integrate;
};

/// From a thousandth, half a decade apart, down to the rounding of numbers.
std::vector<double> tolerances();

/// Each twice the one before.
std::vector<double> numbers_of_steps();

}  // namespace bench::precision
