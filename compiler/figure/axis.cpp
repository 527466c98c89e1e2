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

Axis around(double value) {
  const double reach = value == 0 ? 1 : std::abs(value) / 2;
  return {value - reach, value + reach};
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
    return around(low + span / 2);
  }
  const double margin = 0.06 * span;
  return {low - margin, high + margin, false, std::clamp(static_cast<int>(std::log10(largest / span)) + 3, 6, 9)};
}

}  // namespace mbcc::figure
