#pragma once
// A chain of unit masses on unit rods from the origin by hand: a_k = g + t_k d_k - t_(k+1) d_(k+1), where the tensions
// t solve a symmetric tridiagonal system in the rods d_k = r_k - r_(k-1).
//
// Tried, with g++ 12 -O3 -march=native; nanoseconds for 3, 10, 100 links:
//   positions x, y, z of one mass side by side                        22,  67, 700
//   x of all masses, then y, then z, Thomas from one end              19,  90, 800
//   the same from both ends, pivots re-read from memory               19,  73, 640
//   the same, pivots carried in registers, no remainder loops         19,  65, 495    what is here
//   every second row first, all at once, the rest from both ends      -,   62, 441    three times the code for a tenth
//   reciprocals of pivots instead of quotients                        10 % slower: one more product in the chain
//   vectors of 512 bits (-mprefer-vector-width=512)                   slower up to 30 links, equal at 100
//   -ffast-math                                                       no difference
//   determinants by a three-term recurrence instead of pivots         19,  60, 460    rejected: they grow as 2^links
//                                                                                     and overflow in long chains

#include <array>
#include <cstddef>

#include "expert/second_order_rk4.hpp"

namespace bench::expert {

/// `Width` >= Links is what the loops over links run to, so that none has a remainder. The masses beyond the last fall
/// freely and hang on nothing. With `IsHeld` the last mass stays where it is: a chain between two points.
template <std::size_t Links, std::size_t Width, bool IsHeld = false>
class Chain {
 public:
  /// x of all masses, then y, then z. Differences read one number beyond the last axis.
  static constexpr std::size_t size = 3 * Width + 4;

  void set_time(double) {}

  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    std::array<Lane, 3> rod;
    Lane diagonal, coupling, right, tension;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double* r = &y.q.values[axis * Width];
      rod[axis][0] = r[0];
      for (std::size_t k = 0; k < Width; ++k) {
        rod[axis][k + 1] = r[k + 1] - r[k];
      }
    }
    equations(rod, y.v, diagonal, coupling, right);
    solve(diagonal, coupling, right, tension);
    for (std::size_t k = Links; k <= Width; ++k) {
      tension[k] = 0;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double gravity = axis == 2 ? -weight : 0;
      double* result = &a.values[axis * Width];
      for (std::size_t k = 0; k < Width; ++k) {
        result[k] = gravity + tension[k] * rod[axis][k] - tension[k + 1] * rod[axis][k + 1];
      }
      if constexpr (IsHeld) {
        result[Links - 1] = 0;
      }
    }
  }

 private:
  using Lane = std::array<double, Width + 4>;
  static constexpr double weight = 9.81;

  /// coupling[k] joins rows k - 1 and k.
  [[gnu::always_inline]] static void equations(const std::array<Lane, 3>& rod, const Vector<size>& v, Lane& diagonal,
                                               Lane& coupling, Lane& right) {
    const auto& [x, y, z] = rod;
    const double* vx = v.values.data();
    const double* vy = vx + Width;
    const double* vz = vy + Width;
    diagonal[0] = x[0] * x[0] + y[0] * y[0] + z[0] * z[0];
    right[0] = weight * z[0] - (vx[0] * vx[0] + vy[0] * vy[0] + vz[0] * vz[0]);
    for (std::size_t k = 0; k < Width; ++k) {
      diagonal[k + 1] = 2 * (x[k + 1] * x[k + 1] + y[k + 1] * y[k + 1] + z[k + 1] * z[k + 1]);
      coupling[k + 1] = -(x[k + 1] * x[k] + y[k + 1] * y[k] + z[k + 1] * z[k]);
      const double wx = vx[k + 1] - vx[k], wy = vy[k + 1] - vy[k], wz = vz[k + 1] - vz[k];
      right[k + 1] = -(wx * wx + wy * wy + wz * wz);
    }
    if constexpr (IsHeld) {
      diagonal[Links - 1] *= 0.5;
      right[Links - 1] -= weight * z[Links - 1];
    }
  }

  /// What an end has eliminated so far: the last row's pivot and right side.
  struct End {
    double pivot, right;

    /// Eliminates the row at this end from its neighbour, whose entries become the end's; returns the factor.
    [[gnu::always_inline]] double step(double coupling, double& diagonal, double& neighbour) {
      const double factor = coupling / pivot;
      diagonal = pivot = diagonal - factor * coupling;
      neighbour = right = neighbour - factor * right;
      return factor;
    }
  };

  /// Eliminates from both ends at once: two chains of dependent divisions run side by side and meet in the middle.
  [[gnu::always_inline]] static void solve(Lane& diagonal, const Lane& coupling, Lane& right, Lane& tension) {
    constexpr std::size_t middle = Links / 2;
    constexpr std::size_t upper = Links - 1 - middle;  // rows beyond the middle; `middle` or one less lie before it
    Lane factor;                                       // beside coupling
    End low{diagonal[0], right[0]};
    End high{diagonal[Links - 1], right[Links - 1]};
    for (std::size_t i = 1; i < upper; ++i) {
      const std::size_t k = Links - i;
      factor[i] = low.step(coupling[i], diagonal[i], right[i]);
      factor[k] = high.step(coupling[k], diagonal[k - 1], right[k - 1]);
    }
    if constexpr (middle > upper) {
      factor[middle - 1] = low.step(coupling[middle - 1], diagonal[middle - 1], right[middle - 1]);
    }
    factor[middle] = low.step(coupling[middle], diagonal[middle], right[middle]);
    factor[middle + 1] = high.step(coupling[middle + 1], diagonal[middle], right[middle]);

    double below = tension[middle] = right[middle] / diagonal[middle];
    double above = below;
    for (std::size_t i = 1; i <= upper; ++i) {
      const std::size_t k = middle - i;
      const std::size_t l = middle + i;
      tension[k] = below = right[k] / diagonal[k] - factor[k + 1] * below;
      tension[l] = above = right[l] / diagonal[l] - factor[l] * above;
    }
    if constexpr (middle > upper) {
      tension[0] = right[0] / diagonal[0] - factor[1] * below;
    }
  }
};

}  // namespace bench::expert
