#pragma once
// The range that the values of a panel are shown on.

#include <span>
#include <vector>

#include "figure/panels.hpp"

namespace mbcc::figure {

struct Axis {
  double low = -1;
  double high = 1;
  bool logarithmic = false;
  double tick = 0.5;  ///< from mark to mark on a linear axis
  int digits = 6;     ///< significant ones that tell marks apart
};

/// The axis of curves that stand in one panel. `extent` is the largest magnitude of what is shown beside them: Note
/// [quiet signals].
///
/// Note [quiet signals]: what does not move is shown as a level line, not its rounding errors on an axis of their own.
/// Values count as equal if they differ by less than 1e-6 of the largest, which is less than the width of a line on
/// any axis that has zero on it; and as zero below 1e-12 of `extent`, where sums of numbers of that size end. Neither
/// holds for a change, whose smallness is what it is looked at for.
Axis axis_of(std::span<const std::vector<double>> curves, Measure measure, double extent);

/// The largest finite magnitude in `values`, at least `so_far`.
double largest_magnitude(std::span<const double> values, double so_far = 0);

}  // namespace mbcc::figure
