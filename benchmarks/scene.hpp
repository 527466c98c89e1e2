#pragma once
// The scenes that are computed in several ways, and where each must end.

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

/// A component of the state at the end time, known independently of this project's code.
struct Known {
  std::size_t component;
  double value;
};

/// A model integrated by classical RK4 with a constant step from time 0. A state is all coordinates, then all speeds,
/// in the order in which the model declares them.
struct Scene {
  std::string model;  ///< the model file's name without .mbd
  std::vector<double> start;
  double step;
  long steps;
  std::vector<Known> end;
  double error_bound;  ///< on the components in `end`: what the method itself owes at this step, rounded up
};

/// The example of Itiki and Neto (2004), section 3, with their step; `end` is its closed form.
Scene paper_example();

/// Unit masses on unit rods from the origin, pulled aside and pushed across. 3, 10, 100 or 200 links; the longer chains
/// are pushed less and for a shorter time, so that all of them move regularly.
Scene chain(std::size_t links);

}  // namespace bench
