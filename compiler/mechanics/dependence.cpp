#include "mechanics/dependence.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace mbcc::mechanics {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Rows of A M^-1/2 at a point, scaled to size 1 (a zero row stays zero), with the sizes they had.
struct ScaledRows {
  MatrixXd matrix;  ///< one row of A M^-1/2 per column
  VectorXd size;
};

ScaledRows scaled_rows(const std::vector<std::size_t>& rows, const Island& island, const Derivatives& derivatives,
                       const Point& point) {
  const auto count = static_cast<Eigen::Index>(rows.size());
  const auto speeds = static_cast<Eigen::Index>(island.speeds.size());
  ScaledRows scaled{MatrixXd::Zero(speeds, count), VectorXd::Zero(count)};
  std::vector<Expr> expressions;
  for (const std::size_t row : rows) {
    for (const Entry& entry : derivatives.rows[row].solved) {
      expressions.push_back(entry.value);
      expressions.push_back(derivatives.mobility[entry.speed]);
    }
  }
  const std::vector<double> values = values_at(point, expressions);
  std::size_t at = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    for (const Entry& entry : derivatives.rows[rows[static_cast<std::size_t>(k)]].solved) {
      const auto column = std::lower_bound(island.speeds.begin(), island.speeds.end(), entry.speed);
      scaled.matrix(column - island.speeds.begin(), k) = values[at] * std::sqrt(values[at + 1]);
      at += 2;
    }
    scaled.size[k] = scaled.matrix.col(k).norm();
    if (scaled.size[k] > 0) {
      scaled.matrix.col(k) /= scaled.size[k];
    }
  }
  return scaled;
}

/// A Cholesky factorization that goes through with safe pivots proves full rank at a fraction of the cost.
bool clearly_independent(const MatrixXd& rows) {
  const Eigen::LLT<MatrixXd> factorization(rows.transpose() * rows);
  return factorization.info() == Eigen::Success &&
         factorization.matrixLLT().diagonal().cwiseAbs().minCoeff() > std::sqrt(rank_cutoff);
}

}  // namespace

std::vector<Dependence> find_dependences(const Island& island, const Derivatives& derivatives, const Point& point) {
  std::vector<std::size_t> rows = island.rows;
  rows.insert(rows.end(), island.held.begin(), island.held.end());
  std::sort(rows.begin(), rows.end());
  const ScaledRows scaled = scaled_rows(rows, island, derivatives, point);
  std::vector<Dependence> dependences;
  if (clearly_independent(scaled.matrix)) {
    return dependences;
  }
  MatrixXd basis(scaled.matrix.rows(), scaled.matrix.cols());  // orthonormal; first `rank` columns are valid
  std::vector<Eigen::Index> independent;
  for (Eigen::Index k = 0; k < scaled.matrix.cols(); ++k) {
    const auto rank = static_cast<Eigen::Index>(independent.size());
    VectorXd rest = scaled.matrix.col(k);
    for (int pass = 0; pass < 2; ++pass) {  // twice is enough for orthogonality to rounding
      rest -= basis.leftCols(rank) * (basis.leftCols(rank).transpose() * rest);
    }
    if (rest.norm() > rank_cutoff) {
      basis.col(rank) = rest.normalized();
      independent.push_back(k);
      continue;
    }
    Dependence dependence{rows[static_cast<std::size_t>(k)], {}, 0};
    if (rank > 0 && scaled.size[k] > 0) {
      const VectorXd coefficients =
          scaled.matrix(Eigen::all, independent).colPivHouseholderQr().solve(scaled.matrix.col(k));
      for (Eigen::Index j = 0; j < rank; ++j) {
        const Eigen::Index other = independent[static_cast<std::size_t>(j)];
        if (std::abs(coefficients[j]) > rank_cutoff) {
          dependence.on.emplace_back(rows[static_cast<std::size_t>(other)],
                                     coefficients[j] * scaled.size[k] / scaled.size[other]);
          dependence.growth = std::max(dependence.growth, std::abs(coefficients[j]));
        }
      }
    }
    dependences.push_back(std::move(dependence));
  }
  return dependences;
}

}  // namespace mbcc::mechanics
