#pragma once
// Two pairs of order 8: that of Dormand and Prince, and Fehlberg's.

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>

#include "mbrt/dop853_coefficients.hpp"

namespace bench::expert {

/// Hairer's DOP853: two estimates, of order 5 and 3, in one. The table is the runtime's; the code around it is not.
struct Dop853 {
  static constexpr std::size_t stages = mbrt::dop853::stages;
  static constexpr double node(std::size_t stage) { return mbrt::dop853::nodes[stage]; }
  template <std::size_t S>
  using Stage = mbrt::dop853::StageSum<S>;
  using Estimates = std::tuple<mbrt::dop853::FifthOrderError, mbrt::dop853::ThirdOrderError>;

  static double error(double h, double fifth, double third) {
    return fifth == 0 ? 0 : h * fifth * fifth / std::sqrt(fifth * fifth + 0.01 * third * third);
  }
};

/// RKF78: E. Fehlberg, Classical fifth-, sixth-, seventh-, and eighth-order Runge-Kutta formulas with stepsize control,
/// NASA TR R-287 (1968), table X. Steps are those of order 8.
struct Rkf78 {
  static constexpr std::size_t stages = 13;
  static constexpr std::array<double, stages> nodes{0,       2.0 / 27, 1.0 / 9, 1.0 / 6, 5.0 / 12, 1.0 / 2, 5.0 / 6,
                                                    1.0 / 6, 2.0 / 3,  1.0 / 3, 1,       0,        1};
  static constexpr std::array<std::array<double, stages>, stages + 1> weights{{
      {},
      {2.0 / 27},
      {1.0 / 36, 1.0 / 12},
      {1.0 / 24, 0, 1.0 / 8},
      {5.0 / 12, 0, -25.0 / 16, 25.0 / 16},
      {1.0 / 20, 0, 0, 1.0 / 4, 1.0 / 5},
      {-25.0 / 108, 0, 0, 125.0 / 108, -65.0 / 27, 125.0 / 54},
      {31.0 / 300, 0, 0, 0, 61.0 / 225, -2.0 / 9, 13.0 / 900},
      {2, 0, 0, -53.0 / 6, 704.0 / 45, -107.0 / 9, 67.0 / 90, 3},
      {-91.0 / 108, 0, 0, 23.0 / 108, -976.0 / 135, 311.0 / 54, -19.0 / 60, 17.0 / 6, -1.0 / 12},
      {2383.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -301.0 / 82, 2133.0 / 4100, 45.0 / 82, 45.0 / 164, 18.0 / 41},
      {3.0 / 205, 0, 0, 0, 0, -6.0 / 41, -3.0 / 205, -3.0 / 41, 3.0 / 41, 6.0 / 41},
      {-1777.0 / 4100, 0, 0, -341.0 / 164, 4496.0 / 1025, -289.0 / 82, 2193.0 / 4100, 51.0 / 82, 33.0 / 164, 12.0 / 41,
       0, 1},
      {0, 0, 0, 0, 0, 34.0 / 105, 9.0 / 35, 9.0 / 35, 9.0 / 280, 9.0 / 280, 0, 41.0 / 840, 41.0 / 840},
  }};

  static constexpr double node(std::size_t stage) { return nodes[stage]; }
  template <std::size_t S>
  struct Stage {
    static constexpr std::size_t count = S;
    static constexpr double at(std::size_t i) { return weights[S][i]; }
  };
  struct Estimate {
    static constexpr std::size_t count = stages;
    static constexpr double at(std::size_t i) {
      return i == 0 || i == 10 ? 41.0 / 840 : i == 11 || i == 12 ? -41.0 / 840 : 0;
    }
  };
  using Estimates = std::tuple<Estimate>;

  static double error(double h, double estimate) { return h * estimate; }
};

}  // namespace bench::expert
