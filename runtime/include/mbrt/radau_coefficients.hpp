#pragma once
// Coefficients of the Radau IIA method of order 5: Hairer and Wanner, Solving Ordinary Differential Equations II,
// sections IV.5 (table 5.6) and IV.8.

#include <array>
#include <cstddef>

namespace mbrt::radau {

inline constexpr std::size_t stages = 3;
inline constexpr double sqrt6 = 2.449489742783178098197284;

/// Where in a step the stages are.
inline constexpr std::array nodes = {(4 - sqrt6) / 10, (4 + sqrt6) / 10, 1.0};

/// A complex number, without the streams that <complex> brings along.
struct Complex {
  double real;
  double imaginary;
};

/// The eigenvalues of the inverse of the method's matrix A: a real one, and one of the pair.
inline constexpr double real_eigenvalue = 3.637834252744495732208419;
inline constexpr Complex eigenvalue = {2.681082873627752133895790, 3.050430199247410569426378};

using Matrix = std::array<std::array<double, stages>, stages>;

/// T, in whose columns are the eigenvector of the first, and real and imaginary part of that of the conjugate of the
/// second, with 1 as last component: T^-1 A^-1 T is their blocks (section IV.8).
inline constexpr Matrix from_blocks = {
    {{0.09443876248897524148749, -0.1412552950209542084280, -0.03002919410514742449186},
     {0.2502131229653333113765, 0.2041293522937999319960, 0.3829421127572619377954},
     {1.0, 1.0, 0.0}}};

/// The inverse by cofactors.
constexpr Matrix inverse(const Matrix& m) {
  const auto minor = [&m](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      result[i][j] = minor(j, i) / determinant;
    }
  }
  return result;
}
inline constexpr Matrix to_blocks = inverse(from_blocks);

/// Weights of the stages, over the step, in the estimate of its error: equation (8.19), divided by gamma_0, the inverse
/// of the real eigenvalue.
inline constexpr std::array error_weights = {-(13 + 7 * sqrt6) / 3, (-13 + 7 * sqrt6) / 3, -1.0 / 3};

}  // namespace mbrt::radau
