#pragma once
// The equation of constrained motion as printed, x'' = a + M^(-1/2) (A M^(-1/2))^+ (b - A a), with A and b from dual
// numbers and the generalised inverse from a singular value decomposition: what one gets from general libraries.

#include <Eigen/SVD>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "generic/jet.hpp"

namespace bench::generic {

/// Relative cut-off of the generalised inverse; a library's default takes rounding for rank in the paper's example.
inline constexpr double cutoff = 1e-8;

/// As Eigen advises: Jacobi for small matrices, divide and conquer beyond.
template <class Scene>
using Svd = std::conditional_t<(Scene::holonomic + Scene::nonholonomic <= 16), Eigen::JacobiSVD<Eigen::MatrixXd>,
                               Eigen::BDCSVD<Eigen::MatrixXd>>;

/// A system for mbrt::rk4.
template <class Scene>
class UdwadiaKalaba {
 public:
  static constexpr std::size_t size = Scene::coordinates;
  static constexpr std::size_t rows = Scene::holonomic + Scene::nonholonomic;
  using State = std::array<double, 2 * size>;

  void set_time(double time) { time_ = time; }

  void rates(const State& y, State& rate) {
    const std::span<const double> x(y.data(), size);
    const std::span<const double> v(y.data() + size, size);
    differentiate(x, v);
    Scene::forces(x, std::span<double>(force_.data(), size));
    const Eigen::VectorXd free = inverse_mass_.asDiagonal() * force_;
    const Eigen::VectorXd root = inverse_mass_.cwiseSqrt();
    svd_.compute(matrix_ * root.asDiagonal(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd_.setThreshold(cutoff);
    const Eigen::VectorXd acceleration = free + root.asDiagonal() * svd_.solve(right_ - matrix_ * free);
    for (std::size_t j = 0; j < size; ++j) {
      rate[j] = v[j];
      rate[size + j] = acceleration[static_cast<Eigen::Index>(j)];
    }
  }

 private:
  using Number = Jet<static_cast<int>(size)>;

  /// Holonomic rows are differentiated twice along the motion, nonholonomic ones once; A is dh/dx or dg/dv.
  void differentiate(std::span<const double> x, std::span<const double> v) {
    Number t(time_);
    t.first = 1;
    seed(x, v, Scene::holonomic > 0);
    Scene::template constraints<Number>(t, x_, v_, values_);
    for (std::size_t k = 0; k < Scene::holonomic; ++k) {
      take(k, -values_[k].second);
    }
    if constexpr (Scene::nonholonomic > 0) {
      seed(x, v, false);
      Scene::template constraints<Number>(t, x_, v_, values_);
      for (std::size_t k = Scene::holonomic; k < rows; ++k) {
        take(k, -values_[k].first);
      }
    }
  }

  /// Positions move with the velocities; gradients are with respect to one or the other.
  void seed(std::span<const double> x, std::span<const double> v, bool by_position) {
    for (std::size_t j = 0; j < size; ++j) {
      x_[j] = Number(x[j]);
      v_[j] = Number(v[j]);
      x_[j].first = v[j];
      (by_position ? x_[j] : v_[j]).gradient[static_cast<Eigen::Index>(j)] = 1;
    }
  }

  void take(std::size_t row, double right) {
    const auto k = static_cast<Eigen::Index>(row);
    matrix_.row(k) = values_[row].gradient.matrix().transpose();
    right_[k] = right;
  }

  static constexpr auto columns = static_cast<Eigen::Index>(size);
  static constexpr auto equations = static_cast<Eigen::Index>(rows);

  double time_ = 0;
  std::vector<Number> x_ = std::vector<Number>(size), v_ = x_, values_ = std::vector<Number>(rows);
  Eigen::VectorXd inverse_mass_ = Eigen::VectorXd::Ones(columns);
  Eigen::VectorXd force_ = Eigen::VectorXd::Zero(columns);
  Eigen::MatrixXd matrix_ = Eigen::MatrixXd::Zero(equations, columns);
  Eigen::VectorXd right_ = Eigen::VectorXd::Zero(equations);
  Svd<Scene> svd_{equations, columns, Eigen::ComputeThinU | Eigen::ComputeThinV};
};

}  // namespace bench::generic
