#pragma once
// What is known of the motion within a step of Radau IIA, and beyond it.

#include <array>
#include <cstddef>

#include "mbrt/radau_coefficients.hpp"

namespace mbrt {

/// The polynomial through the begin of the last step and its stages, of degree 3; the part s of the step runs from 0 to
/// 1, and beyond to extrapolate.
template <class State>
class Collocation {
 public:
  /// For states of the size of `like`.
  explicit Collocation(const State& like) : begin_slope_(like), end_slope_(like) { differences_.fill(like); }

  double length() const { return length_; }

  /// Where the first step begins.
  void start(const State& rate) { end_slope_ = rate; }

  /// The step of length h that follows the last one: its stages, less its begin. It ends at `end`, to where the last
  /// stage was moved. Divided differences over the nodes 0, 1, c2, c1.
  void take(const std::array<State, radau::stages>& stages, const State& begin, const State& end, double h) {
    constexpr double c1 = radau::nodes[0], c2 = radau::nodes[1];
    length_ = h;
    begin_slope_ = end_slope_;
    for (std::size_t j = 0; j < begin.size(); ++j) {
      const double whole = end[j] - begin[j];
      const double upper = (whole - stages[1][j]) / (1 - c2);
      const double lower = (stages[1][j] - stages[0][j]) / (c2 - c1);
      const double second = (upper - whole) / c2;
      const double third = ((lower - upper) / (c1 - 1) - second) / c1;
      differences_[0][j] = whole;
      differences_[1][j] = second;
      differences_[2][j] = third;
      end_slope_[j] = (whole + second + (1 - c2) * third) / h;
    }
  }

  /// Component j at s, less its begin.
  double operator()(double s, std::size_t j) const {
    return s * (differences_[0][j] + (s - 1) * (differences_[1][j] + (s - radau::nodes[1]) * differences_[2][j]));
  }

  struct Pair {
    double coordinate;
    double speed;
  };

  /// A coordinate, and component u, which is its speed, from their values at both ends: the polynomial of degree 5 that
  /// has the accelerations there too. These are those of the collocation: a rate at a state multiplies the error of the
  /// state by the stiffness.
  Pair between(double s, const Pair& begin, const Pair& end, std::size_t u) const {
    const double h = length_;
    const double u0 = h * begin.speed, a0 = h * h * begin_slope_[u];
    const double way = end.coordinate - begin.coordinate - u0 - 0.5 * a0;
    const double gain = h * (end.speed - begin.speed) - a0;
    const double jump = h * h * end_slope_[u] - a0;
    const double c3 = 10 * way - 4 * gain + 0.5 * jump;
    const double c4 = -15 * way + 7 * gain - jump;
    const double c5 = 6 * way - 3 * gain + 0.5 * jump;
    return {begin.coordinate + s * (u0 + s * (0.5 * a0 + s * (c3 + s * (c4 + s * c5)))),
            (u0 + s * (a0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)))) / h};
  }

 private:
  std::array<State, radau::stages> differences_;
  State begin_slope_, end_slope_;  ///< derivatives of the polynomials of this step and the one before
  double length_ = 0;
};

}  // namespace mbrt
