#pragma once
// Particles without constraints, by hand.

#include <array>
#include <cmath>
#include <cstddef>

#include "expert/second_order_rk4.hpp"

namespace bench::expert {

/// A body around a fixed centre with mu = 1.
struct Kepler {
  static constexpr std::size_t size = 3;
  void set_time(double) {}
  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    const double square = y.q[0] * y.q[0] + y.q[1] * y.q[1] + y.q[2] * y.q[2];
    const double pull = -1 / (square * std::sqrt(square));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = pull * y.q[axis];
    }
  }
};

struct HenonHeiles {
  static constexpr std::size_t size = 2;
  void set_time(double) {}
  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    const double x = y.q[0], z = y.q[1];
    a[0] = -x - 2 * x * z;
    a[1] = -z - x * x + z * z;
  }
};

/// Bodies that attract one another; each pair is visited once.
template <std::size_t Bodies>
struct Planets {
  static constexpr std::size_t size = 3 * Bodies;
  std::array<double, Bodies> gm;

  void set_time(double) {}
  [[gnu::always_inline]] void acceleration(const Motion<size>& y, Vector<size>& a) const {
    for (std::size_t j = 0; j < size; ++j) {
      a[j] = 0;
    }
    for (std::size_t i = 0; i < Bodies; ++i) {
      for (std::size_t j = i + 1; j < Bodies; ++j) {
        const double* const p = &y.q.values[3 * i];
        const double* const o = &y.q.values[3 * j];
        const double x = o[0] - p[0], yy = o[1] - p[1], z = o[2] - p[2];
        const double square = x * x + yy * yy + z * z;
        const double cube = 1 / (square * std::sqrt(square));
        const double on_i = gm[j] * cube, on_j = gm[i] * cube;
        a[3 * i] += on_i * x;
        a[3 * i + 1] += on_i * yy;
        a[3 * i + 2] += on_i * z;
        a[3 * j] -= on_j * x;
        a[3 * j + 1] -= on_j * yy;
        a[3 * j + 2] -= on_j * z;
      }
    }
  }
};

}  // namespace bench::expert
