#pragma once
// Motions with known end states.

#include <string>
#include <vector>

#include "scene.hpp"

namespace bench::precision {

struct Problem {
  std::string name;
  std::string model;  ///< the model file's name without .mbd
  std::string title;
  double to;               ///< from 0
  std::vector<Known> end;  ///< what is watched: components of coordinates, then speeds, in the order of the model
};

std::vector<Problem> problems();

}  // namespace bench::precision
