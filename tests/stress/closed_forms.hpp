#pragma once
// Motions that elliptic functions give.

#include <array>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>

namespace mbcc::test {

/// A pendulum, phi'' = -rate^2 sin(phi), that is released at rest from the angle `start`.
struct Swing {
  double start, rate;

  [[nodiscard]] double modulus() const { return std::sin(start / 2); }
  [[nodiscard]] double period() const { return 4 * boost::math::ellint_1(modulus()) / rate; }
  /// sin(phi/2) = k cd(rate t, k)
  [[nodiscard]] double angle(double t) const {
    double cn = 0, dn = 0;
    boost::math::jacobi_elliptic(modulus(), rate * t, &cn, &dn);
    return 2 * std::asin(modulus() * cn / dn);
  }
};

/// phi'' = w sin(phi) from phi = 0 with phi' = start: a pendulum that turns over from its upright position. phi = 2 psi
/// has psi'^2 = start^2/4 + w sin^2(psi), which is sin(psi) = k' sd(r t, k), cos(psi) = cd(r t, k) with r^2 = start^2/4
/// + w and k^2 = w/r^2.
struct Tumble {
  double w, start;

  /// sin and cos of phi.
  [[nodiscard]] std::array<double, 2> direction(double t) const {
    const double r = std::sqrt(start * start / 4 + w);
    double cn = 0, dn = 0;
    const double sn = boost::math::jacobi_elliptic(std::sqrt(w) / r, r * t, &cn, &dn);
    const double sine = start / (2 * r) * sn / dn, cosine = cn / dn;
    return {2 * sine * cosine, cosine * cosine - sine * sine};
  }
  /// phi' where cos(phi) is this.
  [[nodiscard]] double rate(double cosine) const { return std::sqrt(start * start + 2 * w * (1 - cosine)); }
};

}  // namespace mbcc::test
