#pragma once
// A reference integrator that shares nothing with the runtime's: extrapolation of the modified midpoint rule (Gragg,
// Bulirsch and Stoer; Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.9), with
// constant steps of any even order, in any precision.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace mbcc::test {

/// y' = rate(t, y) over one step h by `substeps` midpoint rules; their error is a series in (h/substeps)^2.
template <class T, class Rate>
std::vector<T> midpoints(const Rate& rate, const T& t, const std::vector<T>& y, const T& h, int substeps) {
  const T part = h / substeps;
  std::vector<T> before = y, now = y;
  const auto add = [](std::vector<T>& sum, const T& factor, const std::vector<T>& term) {
    for (std::size_t j = 0; j < sum.size(); ++j) {
      sum[j] += factor * term[j];
    }
  };
  add(now, part, rate(t, y));
  for (int i = 1; i < substeps; ++i) {
    add(before, 2 * part, rate(t + i * part, now));
    std::swap(before, now);
  }
  return now;
}

/// The state at t + h, and how far it is from that of the next lower order.
template <class T>
struct Extrapolated {
  std::vector<T> state;
  T doubt;
};

/// Of order 2*rows.
template <std::size_t rows, class T, class Rate>
Extrapolated<T> extrapolate(const Rate& rate, const T& t, const std::vector<T>& y, const T& h) {
  std::array<std::vector<T>, rows> table;  // row j of Neville's scheme in elements j, j-1, ..., 0
  for (std::size_t j = 0; j < rows; ++j) {
    table[j] = midpoints(rate, t, y, h, static_cast<int>(2 * (j + 1)));
    for (std::size_t k = j; k-- > 0;) {
      const T ratio = T(j + 1) / T(k + 1);
      for (std::size_t i = 0; i < y.size(); ++i) {
        table[k][i] = table[k + 1][i] + (table[k + 1][i] - table[k][i]) / (ratio * ratio - 1);
      }
    }
  }
  T doubt = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    using std::abs;
    doubt = std::max<T>(doubt, abs(table[0][i] - table[1][i]));
  }
  return {table[0], doubt};
}

}  // namespace mbcc::test
