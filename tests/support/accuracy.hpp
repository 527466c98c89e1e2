#pragma once
// How tests state accuracy: a value within an absolute tolerance, and the order that halving the step shows.

#include <catch2/catch.hpp>
#include <cmath>
#include <string>

namespace mbcc::test {

inline Catch::Detail::Approx near(double value, double tolerance) {
  return Catch::Detail::Approx(value).epsilon(0).margin(tolerance);
}

/// 4 for a method of order four, from the errors at a step and at half of it.
inline double observed_order(double error, double error_at_half) { return std::log2(error / error_at_half); }

/// A step as a flag's value, without loss.
inline std::string flag(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

}  // namespace mbcc::test
