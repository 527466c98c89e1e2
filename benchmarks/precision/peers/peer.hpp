#pragma once
// What the programs share that solve the scenes with another library: a scene from a file, and the lines printed.

#include <functional>
#include <string>
#include <vector>

#include "precision/contender.hpp"
#include "precision/hung_chain.hpp"

namespace bench::precision {

/// Weight of a unit mass, down along z.
inline constexpr double gravity = 9.81;

/// Measures what `contenders` gives for each scene file of the command line and prints a line for each point: problem,
/// contender, setting, seconds, error. Exit code 1 with a message where a file cannot be read or a library throws.
int run_peer(int argc, char** argv, const std::function<std::vector<Contender>(const HungChain&)>& contenders);

/// What a scene watches, from a function of mass and axis.
template <class Coordinate>
std::vector<double> watched(const HungChain& chain, const Coordinate& coordinate) {
  std::vector<double> values;
  for (const HungChain::Watched& one : chain.watched) {
    values.push_back(coordinate(one.mass, one.axis));
  }
  return values;
}

}  // namespace bench::precision
