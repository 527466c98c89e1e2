#pragma once
// Classical RK4 for q'' = a(t, q, v), as one writes it who knows that q' = v need not be computed: rates of positions
// are never stored, sums are accumulated while the stage is in cache.

#include <array>
#include <cstddef>

namespace bench::expert {

template <std::size_t Size>
struct alignas(64) Vector {
  std::array<double, Size> values{};

  double& operator[](std::size_t i) { return values[i]; }
  double operator[](std::size_t i) const { return values[i]; }
};

template <std::size_t Size>
struct Motion {
  Vector<Size> q, v;
};

/// Slopes summed over the stages with the weights of the method.
template <std::size_t Size>
using Slopes = Motion<Size>;

/// One component of the next stage, from `y` along a slope.
template <std::size_t Size>
[[gnu::always_inline]] inline void advance(const Motion<Size>& y, double v, double a, double length, std::size_t j,
                                           Motion<Size>& next) {
  next.q[j] = y.q[j] + length * v;
  next.v[j] = y.v[j] + length * a;
}

/// The first pass of a step: begins the sum of slopes and makes the second stage.
template <std::size_t Size>
[[gnu::always_inline]] inline void begin(const Motion<Size>& y, const Vector<Size>& a, double length, Slopes<Size>& sum,
                                         Motion<Size>& stage) {
  for (std::size_t j = 0; j < Size; ++j) {
    const double v = y.v[j];
    sum.q[j] = v;
    sum.v[j] = a[j];
    advance(y, v, a[j], length, j, stage);
  }
}

/// A middle pass: adds the slope of `stage` to the sum and moves along it to the next stage.
template <std::size_t Size>
[[gnu::always_inline]] inline void pass(const Motion<Size>& y, const Vector<Size>& a, double length, Slopes<Size>& sum,
                                        Motion<Size>& stage) {
  for (std::size_t j = 0; j < Size; ++j) {
    const double v = stage.v[j];
    sum.q[j] += 2 * v;
    sum.v[j] += 2 * a[j];
    advance(y, v, a[j], length, j, stage);
  }
}

/// `Model` has set_time(t) and acceleration(motion, a). The time at a step's end is the next one's beginning and set
/// once. Model and motion are taken by value, so that nothing else can see them and they may live in registers.
template <std::size_t Size, class Model>
Motion<Size> rk4(Model model, Motion<Size> y, double step, long steps) {
  Vector<Size> a;
  Motion<Size> stage;
  Slopes<Size> sum;
  model.set_time(0);
  for (long i = 0; i < steps; ++i) {
    const double t = static_cast<double>(i) * step;
    model.acceleration(y, a);
    begin(y, a, step / 2, sum, stage);
    model.set_time(t + step / 2);
    model.acceleration(stage, a);
    pass(y, a, step / 2, sum, stage);
    model.acceleration(stage, a);
    pass(y, a, step, sum, stage);
    model.set_time(static_cast<double>(i + 1) * step);
    model.acceleration(stage, a);
    for (std::size_t j = 0; j < Size; ++j) {
      y.q[j] += step / 6 * (sum.q[j] + stage.v[j]);
      y.v[j] += step / 6 * (sum.v[j] + a[j]);
    }
  }
  return y;
}

}  // namespace bench::expert
