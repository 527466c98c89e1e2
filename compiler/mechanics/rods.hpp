#pragma once
// Which constraints are rods: they keep a distance.

#include <array>
#include <optional>
#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/point.hpp"

namespace mbcc::mechanics {

/// A constraint that keeps the distance of a place from another, or from a fixed point.
struct Rod {
  std::size_t constraint;
  std::size_t place;                 ///< index into System::places
  std::optional<std::size_t> other;  ///< a later one; else the rod hangs from `anchor`
  std::array<double, 3> anchor{};    ///< x, y, z; good to about nine digits
};

/// The rods among the constraints, in their order. Decided by what a constraint computes, not by how it is written: it
/// has no time in it, depends on at most two places, and at several states around `point` its gradients along these two
/// are opposite and in line with them; of a single place, the lines of the gradients meet in one point, the anchor.
std::vector<Rod> find_rods(const model::System& system, const Derivatives& derivatives, const Point& point);

}  // namespace mbcc::mechanics
