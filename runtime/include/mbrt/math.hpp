#pragma once
// Functions that emitted expressions need beyond <cmath>. Each lets a NaN pass, so that it is reported where it began.

#include <cmath>

namespace mbrt {

/// -1, 0 or 1; 0 at either zero.
constexpr double sign(double x) { return x > 0 ? 1 : x < 0 ? -1 : x; }

/// The smaller operand, the left one where they are equal.
constexpr double min(double a, double b) { return a <= b || a != a ? a : b; }

/// The larger operand, the left one where they are equal.
constexpr double max(double a, double b) { return b <= a || a != a ? a : b; }

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of one angle for little more than the price of one of them.
inline SinCos sincos(double angle) {
#if defined(__GLIBC__) && defined(_GNU_SOURCE)
  SinCos pair;
  ::sincos(angle, &pair.sin, &pair.cos);
  return pair;
#else
  return {std::sin(angle), std::cos(angle)};
#endif
}

/// Whether no element of a range is infinite or NaN.
template <class Range>
bool all_finite(const Range& values) {
  for (const double value : values) {
    if (!std::isfinite(value)) {
      return false;
    }
  }
  return true;
}

}  // namespace mbrt
