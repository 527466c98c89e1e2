#pragma once
// Islands with rows of chosen condition.

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "mbrt/island.hpp"

namespace mbrt::test {

/// Owns the storage of an island of any size.
struct DynamicIsland {
  DynamicIsland(std::size_t rows, std::size_t columns)
      : scale(rows),
        floor(rows),
        scratch(scratch_size(rows, columns)),
        matrix(rows * columns),
        residual(rows),
        free(columns),
        mobility(columns),
        position(rows),
        velocity(rows) {
    record.rank = static_cast<int>(rows);
  }
  Island view() { return {scale, floor, scratch, {matrix, residual, free, mobility, position, velocity}, &record}; }

  std::vector<double> scale, floor, scratch, matrix, residual, free, mobility, position, velocity;
  IslandRecord record;
};

/// The rows of one island at one state.
struct Rows {
  Eigen::MatrixXd a;
  Eigen::VectorXd r;
  Eigen::VectorXd mobility;
};

inline void fill(DynamicIsland& island, const Rows& rows) {
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  Eigen::Map<RowMajor>(island.matrix.data(), rows.a.rows(), rows.a.cols()) = rows.a;
  Eigen::Map<Eigen::VectorXd>(island.residual.data(), rows.r.size()) = rows.r;
  Eigen::Map<Eigen::VectorXd>(island.mobility.data(), rows.mobility.size()) = rows.mobility;
}

class RandomRows {
 public:
  explicit RandomRows(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine_); }

  Eigen::MatrixXd normal(Eigen::Index rows, Eigen::Index columns) {
    std::normal_distribution<double> distribution;
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return distribution(engine_); });
  }

  Eigen::MatrixXd orthogonal(Eigen::Index size) {
    return Eigen::HouseholderQR<Eigen::MatrixXd>(normal(size, size)).householderQ();
  }

  /// A M^-1/2 has singular values from 1 down to 1/condition; masses from 0.01 to 100.
  Rows rows(Eigen::Index count, Eigen::Index columns, double condition) {
    const Eigen::Index rank = std::min(count, columns);
    Eigen::MatrixXd sigma = Eigen::MatrixXd::Zero(count, columns);
    for (Eigen::Index k = 0; k < rank; ++k) {
      const double part = k == 0 ? 0 : k + 1 == rank ? 1 : uniform(0, 1);
      sigma(k, k) = std::pow(condition, -part);
    }
    Rows result;
    result.mobility = Eigen::VectorXd::NullaryExpr(columns, [&] { return std::pow(10, uniform(-2, 2)); });
    result.a =
        orthogonal(count) * sigma * orthogonal(columns) * result.mobility.cwiseSqrt().cwiseInverse().asDiagonal();
    result.r = normal(count, 1);
    return result;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mbrt::test
