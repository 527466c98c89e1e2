#pragma once
// Scenes of unit masses in a row, joined by rods, from the origin to a free or to a held end: pendulum, chains, the
// four-bar, and the ring. Code by hand and other programs make them from this.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "precision/problems.hpp"

namespace bench::precision {

struct HungChain {
  struct Mass {
    std::array<double, 3> position, velocity;
  };
  struct Watched {
    std::size_t mass, axis;
    double value;  ///< of the coordinate, at the end
  };

  std::vector<Mass> masses;
  std::optional<std::array<double, 3>> far_end;  ///< which a rod joins to the last mass
  double to;
  std::vector<Watched> watched;
};

/// The scene of a problem, from the start that its model has; nothing if the problem is not of this kind. Planes are
/// vertical, their second axis is z.
std::optional<HungChain> hung_chain(const Problem& problem, const std::vector<double>& start);

/// A line for each fact: `to T`, `mass x y z vx vy vz`, `far x y z`, `watch mass axis value` (counted from 0).
std::string to_text(const HungChain& chain);

}  // namespace bench::precision
