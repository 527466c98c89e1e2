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

/// Unit rods from the origin; with `IsHeld` the last one ends there again.
template <std::size_t Links, bool IsHeld = false>
struct Chain {
  static constexpr std::size_t coordinates = 3 * (IsHeld ? Links - 1 : Links);
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
        const T difference = k == 0 ? x[j] : j >= coordinates ? x[j - 3] : x[j] - x[j - 3];
        sum = sum + difference * difference;
      }
      rows[k] = sum;
    }
  }
};

/// examples/four_bar: crank and rocker in a vertical plane.
struct FourBar {
  static constexpr std::size_t coordinates = 4;
  static constexpr std::size_t holonomic = 3;
  static constexpr std::size_t nonholonomic = 0;

  static void forces(std::span<const double>, std::span<double> f) {
    for (std::size_t j = 0; j < coordinates; ++j) {
      f[j] = j % 2 == 1 ? -9.81 : 0;
    }
  }

  template <class T>
  static void constraints(const T&, std::span<const T> x, std::span<const T>, std::span<T> rows) {
    const T across = x[2] - x[0], up = x[3] - x[1], rocker = x[2] - T(2);
    rows[0] = x[0] * x[0] + x[1] * x[1] - T(1);
    rows[1] = across * across + up * up - T(6.25);
    rows[2] = rocker * rocker + x[3] * x[3] - T(6.25);
  }
};

}  // namespace bench::generic
