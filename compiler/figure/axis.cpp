#include "figure/axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbcc::figure {

namespace {

/// The smallest magnitude of a curve, were it not for the few around which it goes through zero: those run off the
/// axis.
double usual_minimum(std::span<const double> values) {
  std::vector<double> positive;
  std::copy_if(values.begin(), values.end(), std::back_inserter(positive),
               [](double value) { return value > 0 && std::isfinite(value); });
  if (positive.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  const auto rank = positive.begin() + static_cast<std::ptrdiff_t>(positive.size() / 50);
  std::nth_element(positive.begin(), rank, positive.end());
  return *rank;
}

/// Whole decades, at least two. Of numbers that are all zero there are none: they keep a linear axis.
Axis logarithmic_axis(std::span<const std::vector<double>> curves) {
  constexpr double most_decades = 20;
  double low = std::numeric_limits<double>::infinity();
  double high = 0;
  for (const std::vector<double>& curve : curves) {
    low = std::min(low, usual_minimum(curve));
    high = largest_magnitude(curve, high);
  }
  if (high == 0) {
    return {};
  }
  const double top = std::ceil(std::log10(high) + 0.05);  // a curve does not touch the end of its axis
  const double bottom = std::clamp(std::floor(std::log10(low)), top - most_decades, top - 2);
  return {std::pow(10, bottom), std::pow(10, top), true};
}

/// 1, 2 or 5 times a power of ten, at least `step`.
double round_up(double step) {
  const double power = std::pow(10, std::floor(std::log10(step)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= step) {
      return factor * power;
    }
  }
  return 10 * power;
}

Axis linear_axis(double low, double high) {
  constexpr double most_marks = 8;
  const double tick = round_up((high - low) / most_marks);
  const auto exponent = [](double value) { return static_cast<int>(std::floor(std::log10(value))); };
  const int digits = exponent(std::max(std::abs(low), std::abs(high))) - exponent(tick) + 1;
  return {low, high, false, tick, std::clamp(digits, 6, 9)};
}

}  // namespace

double largest_magnitude(std::span<const double> values, double so_far) {
  for (const double value : values) {
    so_far = std::isfinite(value) ? std::max(so_far, std::abs(value)) : so_far;
  }
  return so_far;
}

Axis axis_of(std::span<const std::vector<double>> curves, Measure measure, double extent) {
  if (measure == Measure::Magnitude) {
    return logarithmic_axis(curves);
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const std::vector<double>& curve : curves) {
    for (const double value : curve) {
      low = std::isfinite(value) ? std::min(low, value) : low;
      high = std::isfinite(value) ? std::max(high, value) : high;
    }
  }
  const double largest = std::max(std::abs(low), std::abs(high));
  const bool quiet = measure == Measure::Value;
  if (low > high || largest == 0 || (quiet && largest < 1e-12 * extent)) {
    return {};
  }
  const double span = high - low;
  if (span == 0 || (quiet && span < 1e-6 * largest)) {
    const double level = low + span / 2;
    return linear_axis(level - largest / 2, level + largest / 2);
  }
  const double margin = 0.06 * span;
  return linear_axis(low - margin, high + margin);
}

}  // namespace mbcc::figure
