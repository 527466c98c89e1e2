#include "precision/contender.hpp"

#include <cmath>

namespace bench::precision {

std::vector<double> tolerances() {
  std::vector<double> all;
  for (int half_decades = 6; half_decades <= 30; ++half_decades) {
    all.push_back(std::pow(10, -0.5 * half_decades));
  }
  return all;
}

std::vector<double> numbers_of_steps() {
  std::vector<double> all;
  for (double steps = 64; steps < 1e7; steps *= 2) {
    all.push_back(steps);
  }
  return all;
}

}  // namespace bench::precision
