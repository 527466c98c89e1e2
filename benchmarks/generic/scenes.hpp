#pragma once
// The scenes as one gives them to a general program: applied forces and constraints, in any algebra.

#include <array>
#include <cstddef>
#include <numbers>
#include <span>

namespace bench::generic {

/// All masses are 1. `holonomic` rows are functions of time and position, the rest of position and velocity as well.
struct PaperExample {
  static constexpr std::size_t coordinates = 6;
  static constexpr std::size_t holonomic = 2;
  static constexpr std::size_t nonholonomic = 2;

  static void forces(std::span<const double> x, std::span<double> f) {
    for (std::size_t j = 0; j < coordinates; ++j) {
      f[j] = j < 3 ? -9.81 * x[j] : 0;
    }
  }

  template <class T>
  static void constraints(const T& t, std::span<const T> x, std::span<const T> v, std::span<T> rows) {
    const T angle = T(2 * std::numbers::pi) * t;
    rows[0] = x[0] * x[0] + x[1] * x[1] + x[2] * x[2] - T(1);
    rows[1] = x[0] * sin(angle) - x[1] * cos(angle);
    rows[2] = x[5] * v[3] - v[4];
    rows[3] = x[5] * x[5] * v[3] - v[4];
  }
};

template <std::size_t Links>
struct Chain {
  static constexpr std::size_t coordinates = 3 * Links;
  static constexpr std::size_t holonomic = Links;
  static constexpr std::size_t nonholonomic = 0;

  static void forces(std::span<const double>, std::span<double> f) {
    for (std::size_t j = 0; j < coordinates; ++j) {
      f[j] = j % 3 == 2 ? -9.81 : 0;
    }
  }

  template <class T>
  static void constraints(const T&, std::span<const T> x, std::span<const T>, std::span<T> rows) {
    for (std::size_t k = 0; k < Links; ++k) {
      T sum(-1);
      for (std::size_t j = 3 * k; j < 3 * k + 3; ++j) {
        const T difference = k == 0 ? x[j] : x[j] - x[j - 3];
        sum = sum + difference * difference;
      }
      rows[k] = sum;
    }
  }
};

}  // namespace bench::generic
