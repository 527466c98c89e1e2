#pragma once
// Dense forward-mode derivatives: each value carries its gradient and its first two derivatives along the motion, all
// of them through every operation, whether they are zero or not. This is the usual dual number; the paper's vectors of
// all second partials would cost a factor of the size more.

#include <Eigen/Core>
#include <cmath>

namespace bench::generic {

template <int Size>
struct Jet {
  double value = 0;
  double first = 0;   ///< along the motion
  double second = 0;  ///< along the motion, without accelerations
  Eigen::Array<double, Size, 1> gradient = Eigen::Array<double, Size, 1>::Zero();

  Jet() = default;
  Jet(double constant) : value(constant) {}  // NOLINT: numbers are jets
};

template <int Size>
Jet<Size> operator+(const Jet<Size>& a, const Jet<Size>& b) {
  Jet<Size> r;
  r.value = a.value + b.value;
  r.first = a.first + b.first;
  r.second = a.second + b.second;
  r.gradient = a.gradient + b.gradient;
  return r;
}

template <int Size>
Jet<Size> operator-(const Jet<Size>& a, const Jet<Size>& b) {
  Jet<Size> r;
  r.value = a.value - b.value;
  r.first = a.first - b.first;
  r.second = a.second - b.second;
  r.gradient = a.gradient - b.gradient;
  return r;
}

template <int Size>
Jet<Size> operator*(const Jet<Size>& a, const Jet<Size>& b) {
  Jet<Size> r;
  r.value = a.value * b.value;
  r.first = a.first * b.value + a.value * b.first;
  r.second = a.second * b.value + 2 * a.first * b.first + a.value * b.second;
  r.gradient = a.gradient * b.value + a.value * b.gradient;
  return r;
}

/// f(a) from the value and the first two derivatives of f there.
template <int Size>
Jet<Size> compose(const Jet<Size>& a, double f, double slope, double curvature) {
  Jet<Size> r;
  r.value = f;
  r.first = slope * a.first;
  r.second = slope * a.second + curvature * a.first * a.first;
  r.gradient = slope * a.gradient;
  return r;
}

template <int Size>
Jet<Size> sin(const Jet<Size>& a) {
  const double s = std::sin(a.value);
  return compose(a, s, std::cos(a.value), -s);
}

template <int Size>
Jet<Size> cos(const Jet<Size>& a) {
  const double c = std::cos(a.value);
  return compose(a, c, -std::sin(a.value), -c);
}

}  // namespace bench::generic
