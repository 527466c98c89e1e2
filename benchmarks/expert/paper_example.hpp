#pragma once
// The paper's example by hand.
//
// Particle 1 hangs on the two unit normals' directions r and n = (s, -c, 0), s = sin 2 pi t, c = cos 2 pi t, so that
// a = -9.81 r + lambda r + mu n with r.a = -v.v and n.a = -(n.r)'' at a = 0: a 2x2 system with unit diagonal for n, one
// division. Particle 2's two rows (z, -1) and (z^2, -1) give a_x and a_y directly, apart from z = 0 and z = 1 where
// they are one row.
//
// Tried, with g++ 12 -O3 -march=native: rotating sine and cosine by the half step's angle instead of calling sincos
// (7 % less, but not a function of time any more: rounding accumulates), one sincos a step and the half step by the
// addition theorem (3 % less, two ulps worse).

#include <cmath>
#include <cstddef>
#include <numbers>

#include "expert/second_order_rk4.hpp"
#include "mbrt/math.hpp"

namespace bench::expert {

class PaperExample {
 public:
  static constexpr std::size_t size = 6;

  void set_time(double t) {
    const mbrt::SinCos pair = mbrt::sincos(turning * t);
    s_ = pair.sin;
    c_ = pair.cos;
  }

  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    rider(y, a);
    skater(y, a);
  }

 private:
  static constexpr double turning = 2 * std::numbers::pi;
  static constexpr double stiffness = 9.81;
  /// Two rows whose difference z^2 - z is smaller than this are one. The run comes no nearer to it than 1e-3 except at
  /// z = 0, where it is of the size of rounding.
  static constexpr double parallel = 1e-8;

  [[gnu::always_inline]] void rider(const Motion<size>& y, Vector<size>& a) const {
    const double x = y.q[0], yy = y.q[1], z = y.q[2];
    const double vx = y.v[0], vy = y.v[1], vz = y.v[2];
    const double rr = x * x + yy * yy + z * z;
    const double rn = x * s_ - yy * c_;
    const double along_r = stiffness * rr - (vx * vx + vy * vy + vz * vz);
    const double along_n = (turning * turning + stiffness) * rn - 2 * turning * (vx * c_ + vy * s_);
    const double lambda = (along_r - rn * along_n) / (rr - rn * rn);
    const double mu = along_n - rn * lambda;
    const double radial = lambda - stiffness;
    a[0] = radial * x + mu * s_;
    a[1] = radial * yy - mu * c_;
    a[2] = radial * z;
  }

  [[gnu::always_inline]] static void skater(const Motion<size>& y, Vector<size>& a) {
    const double z = y.q[5];
    const double turn = y.v[5] * y.v[3];  // rows: z a_x - a_y = -turn, z^2 a_x - a_y = -2 z turn
    const double difference = z - z * z;
    if (std::abs(difference) > parallel) [[likely]] {
      a[3] = turn * (2 * z - 1) / difference;
      a[4] = z * a[3] + turn;
    } else {
      const double share = turn / (z * z + 1);
      a[3] = -z * share;
      a[4] = share;
    }
    a[5] = 0;
  }

  double s_ = 0, c_ = 1;
};

}  // namespace bench::expert
