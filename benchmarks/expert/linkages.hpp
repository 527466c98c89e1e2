#pragma once
// The smallest linkages by hand: a spherical pendulum, and a four-bar in a vertical plane.

#include <cstddef>

#include "expert/second_order_rk4.hpp"

namespace bench::expert {

inline constexpr double weight = 9.81;

struct Pendulum {
  static constexpr std::size_t size = 3;
  void set_time(double) {}
  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    const double x = y.q[0], yy = y.q[1], z = y.q[2];
    const double vx = y.v[0], vy = y.v[1], vz = y.v[2];
    const double tension = (weight * z - (vx * vx + vy * vy + vz * vz)) / (x * x + yy * yy + z * z);
    a[0] = tension * x;
    a[1] = tension * yy;
    a[2] = tension * z - weight;
  }
};

/// Unit masses at the ends of crank and rocker; three rods in a row, whose tensions solve a tridiagonal system. It is
/// eliminated from both ends towards the coupler.
struct FourBar {
  static constexpr std::size_t size = 4;
  static constexpr double base = 2;
  void set_time(double) {}
  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    const double cx = y.q[0], cz = y.q[1];                    // crank
    const double rx = y.q[2] - base, rz = y.q[3];             // rocker
    const double bx = y.q[2] - y.q[0], bz = y.q[3] - y.q[1];  // coupler
    const double wx = y.v[2] - y.v[0], wz = y.v[3] - y.v[1];
    const double along_crank = weight * cz - (y.v[0] * y.v[0] + y.v[1] * y.v[1]);
    const double along_rocker = weight * rz - (y.v[2] * y.v[2] + y.v[3] * y.v[3]);
    const double crank_coupler = cx * bx + cz * bz, rocker_coupler = rx * bx + rz * bz;
    const double per_crank = 1 / (cx * cx + cz * cz), per_rocker = 1 / (rx * rx + rz * rz);
    const double u = crank_coupler * per_crank, w = rocker_coupler * per_rocker;
    const double pivot = 2 * (bx * bx + bz * bz) - u * crank_coupler - w * rocker_coupler;
    const double coupler = (-(wx * wx + wz * wz) + u * along_crank - w * along_rocker) / pivot;
    const double crank = along_crank * per_crank + u * coupler;
    const double rocker = along_rocker * per_rocker - w * coupler;
    a[0] = crank * cx - coupler * bx;
    a[1] = crank * cz - coupler * bz - weight;
    a[2] = rocker * rx + coupler * bx;
    a[3] = rocker * rz + coupler * bz - weight;
  }
};

}  // namespace bench::expert
