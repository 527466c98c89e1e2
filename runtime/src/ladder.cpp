// Steps 2 and 3 of Note [rank ladder] in island.hpp. Everything happens in the island's own storage: nothing allocates.
//
// With the row scales in D, the problem is B w = D r, B = D A M^-1/2, and then c = M^-1/2 w.

#include <Eigen/Core>
#include <Eigen/Householder>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mbrt/island.hpp"

namespace mbrt {
namespace {

using Index = Eigen::Index;
using Matrix = Eigen::Map<Eigen::MatrixXd>;
using RowMatrix = Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;
using Vector = Eigen::Map<Eigen::VectorXd>;

/// Hands out the island's scratch storage piece by piece.
class Scratch {
 public:
  explicit Scratch(std::span<double> storage) : rest_(storage) {}

  double* take(Index count) {
    double* const piece = rest_.data();
    rest_ = rest_.subspan(static_cast<std::size_t>(count));
    return piece;
  }

 private:
  std::span<double> rest_;
};

Vector vector(std::span<double> storage) { return {storage.data(), static_cast<Index>(storage.size())}; }

/// The part of a usual S_kk below which LDL^T leaves a row to the pinv: ten times above the cut-off or higher.
double smallest_square(double cutoff) { return std::max(vanishing_ratio, 100 * cutoff * cutoff); }

/// Step 1 multiplies two of the S_kk, which may then leave the range of numbers: rows larger than this at the start, or
/// as small, are left to the steps that scale them.
constexpr double largest_plain_square = 1e100;

/// LDL^T of S = B B^T: D on the diagonal of `factor`, L below it. False, with the factor unfinished, if a pivot is too
/// small for refinement to make up for it.
///
/// Note [noise in pivots]: rounding leaves S_jk off by eps |b_j| |b_k|, and elimination carries that into the pivot d_i
/// as eps g_i^2, where g = |L^-1| (|b_1|, |b_2|, ...). After small pivots g_i is far above |b_i|, and a row that
/// depends on the others leaves a pivot of pure noise that may be large against S_ii: d_i is judged by g_i, not by
/// |b_i|. `growth` takes the g_i, from above: g_i <= |b_i| + sum |L_ij| g_j. For two rows that are nearly parallel g_2
/// = 2 |b_2|, and half of g_i stands for |b_i| in the ratio.
bool factor_squared(const RowMatrix& b, RowMatrix& factor, Vector& growth, double cutoff) {
  const double smallest = smallest_square(cutoff);
  const double ratio = std::max(refined_pivot_ratio, smallest);
  for (Index i = 0; i < b.rows(); ++i) {
    double pivot = b.row(i).squaredNorm();
    growth(i) = std::sqrt(pivot);
    for (Index j = 0; j < i; ++j) {
      factor(i, j) = b.row(i).dot(b.row(j)) - factor.row(i).head(j).dot(factor.row(j).head(j));
    }
    for (Index j = 0; j < i; ++j) {
      const double product = factor(i, j);
      factor(i, j) = product / factor(j, j);
      pivot -= product * factor(i, j);
      growth(i) += std::abs(factor(i, j)) * growth(j);
    }
    if (!(pivot >= std::max(ratio * 0.25 * growth(i) * growth(i), smallest))) {
      return false;
    }
    factor(i, i) = pivot;
  }
  return true;
}

void solve_squared(const RowMatrix& factor, Vector& x) {
  const Index size = factor.rows();
  for (Index i = 1; i < size; ++i) {
    x(i) -= factor.row(i).head(i).dot(x.head(i));
  }
  x.array() /= factor.diagonal().array();
  for (Index i = size - 1; i > 0; --i) {
    x.head(i) -= x(i) * factor.row(i).head(i).transpose();
  }
}

/// Step 2. The residual r - B (B^T z) never sees S, so that the error of w ends near eps cond(B), not its square.
bool solve_refined(const RowMatrix& b, const Vector& r, double cutoff, Scratch scratch, Vector& w) {
  constexpr int refinements = 2;
  const Index rows = b.rows();
  RowMatrix factor(scratch.take(rows * rows), rows, rows);
  Vector z(scratch.take(rows), rows);
  Vector correction(scratch.take(rows), rows);
  if (!factor_squared(b, factor, correction, cutoff)) {
    return false;
  }
  z.setZero();
  correction = r;
  for (int round = 0;; ++round) {
    solve_squared(factor, correction);
    z += correction;
    w.setZero();
    for (Index i = 0; i < rows; ++i) {
      w += z(i) * b.row(i).transpose();
    }
    if (round == refinements) {
      return true;
    }
    for (Index i = 0; i < rows; ++i) {
      correction(i) = r(i) - b.row(i).dot(w);
    }
  }
}

/// Householder QR of B^T (columns x rows) with the longest remaining column next, so that the order of rows does not
/// matter; stops where nothing longer than the cut-off remains, and returns the rank. `r` follows the columns.
Index factor_pivoted(Matrix& transposed, Vector& r, double cutoff, double* tau, double* workspace) {
  const Index columns = transposed.rows();
  const Index rows = transposed.cols();
  double smallest = cutoff;
  for (Index k = 0; k < std::min(rows, columns); ++k) {
    const auto remaining = [&](Index j) { return transposed.col(j).tail(columns - k).norm(); };
    Index longest = k;
    double length = remaining(k);
    for (Index j = k + 1; j < rows; ++j) {
      if (const double candidate = remaining(j); candidate > length) {
        longest = j;
        length = candidate;
      }
    }
    if (k == 0) {
      smallest = cutoff * std::max(length, 1.0);
    }
    if (!(length > smallest)) {
      return k;
    }
    transposed.col(k).swap(transposed.col(longest));
    std::swap(r(k), r(longest));
    double beta = 0;
    transposed.col(k).tail(columns - k).makeHouseholderInPlace(tau[k], beta);
    transposed(k, k) = beta;
    transposed.bottomRightCorner(columns - k, rows - k - 1)
        .applyHouseholderOnTheLeft(transposed.col(k).tail(columns - k - 1), tau[k], workspace);
  }
  return std::min(rows, columns);
}

/// Least squares L y = r for L (rows x rank) of full column rank: y becomes the head of r, and the tail of r what L
/// cannot reach. L becomes its own QR: T above, and below it and in `tau` the reflections.
void solve_least_squares(Matrix& l, Vector& r, double* tau, double* workspace) {
  const Index rows = l.rows();
  const Index rank = l.cols();
  for (Index k = 0; k < rank; ++k) {
    double beta = 0;
    l.col(k).tail(rows - k).makeHouseholderInPlace(tau[k], beta);
    l(k, k) = beta;
    const auto essential = l.col(k).tail(rows - k - 1);
    l.bottomRightCorner(rows - k, rank - k - 1).applyHouseholderOnTheLeft(essential, tau[k], workspace);
    r.tail(rows - k).applyHouseholderOnTheLeft(essential, tau[k], workspace);
  }
  for (Index k = rank - 1; k >= 0; --k) {
    r(k) /= l(k, k);
    r.head(k) -= r(k) * l.col(k).head(k);
  }
}

/// The vector L^+T y, of one number per row, for the QR that solve_least_squares leaves in L.
void apply_transposed_inverse(const Matrix& l, const double* tau, double* workspace, Vector& y) {
  const Index rows = l.rows();
  const Index rank = l.cols();
  for (Index k = 0; k < rank; ++k) {
    y(k) = (y(k) - l.col(k).head(k).dot(y.head(k))) / l(k, k);
  }
  y.tail(rows - rank).setZero();
  for (Index k = rank - 1; k >= 0; --k) {
    y.tail(rows - k).applyHouseholderOnTheLeft(l.col(k).tail(rows - k - 1), tau[k], workspace);
  }
}

/// Step 3: B = P (L E^T) Q^T with L (rows x rank) lower trapezoidal and E below the cut-off, by two factorisations;
/// w = Q (y, E L^+T y), y = L^+ P^T r.
///
/// Note [small rows]: off the constraints, redundant rows are independent by a little, which is E. Without it the
/// result would depend on which of them the order of pivots drops, by as much as E, and would jump where rounding
/// decides it: RK4 then loses an order. With E to first order the result is the truncated pinv but for the square of E.
void solve_orthogonal(Matrix& transposed, Vector& r, Scratch scratch, Vector& w, IslandRecord& record) {
  const Index columns = transposed.rows();
  const Index rows = transposed.cols();
  double* const tau = scratch.take(std::min(rows, columns));
  double* const workspace = scratch.take(rows + columns);
  const double size = r.norm();
  const Index rank = factor_pivoted(transposed, r, record.cutoff, tau, workspace);
  Matrix l(scratch.take(rows * rank), rows, rank);
  for (Index j = 0; j < rank; ++j) {
    l.col(j).head(j).setZero();
    l.col(j).tail(rows - j) = transposed.row(j).tail(rows - j).transpose();
  }
  double* const tau_of_l = scratch.take(rank);
  solve_least_squares(l, r, tau_of_l, workspace);
  record.unreachable = size > 0 ? r.tail(rows - rank).norm() / size : 0;
  w.head(rank) = r.head(rank);
  apply_transposed_inverse(l, tau_of_l, workspace, r);
  w.tail(columns - rank).noalias() = transposed.bottomRightCorner(columns - rank, rows - rank) * r.tail(rows - rank);
  for (Index k = rank - 1; k >= 0; --k) {
    w.tail(columns - k).applyHouseholderOnTheLeft(transposed.col(k).tail(columns - k - 1), tau[k], workspace);
  }
  record.rank = static_cast<int>(rank);
}

}  // namespace

void climb(const Island& island, std::span<double> added) {
  Vector w = vector(added);
  Vector r = vector(island.rows.residual);
  Vector root = vector(island.rows.mobility);
  RowMatrix b(island.rows.matrix.data(), r.size(), root.size());
  root = root.cwiseSqrt();
  for (Index i = 0; i < b.rows(); ++i) {
    const double scale = island.scale[static_cast<std::size_t>(i)];
    r(i) *= scale;
    b.row(i).array() *= scale * root.transpose().array();
  }
  if (!std::isfinite(b.squaredNorm() + r.squaredNorm())) {
    w.setConstant(std::numeric_limits<double>::quiet_NaN());  // for the monitors to find, not for the cut-off to drop
    return;
  }
  IslandRecord& record = *island.record;
  if (solve_refined(b, r, record.cutoff, Scratch(island.scratch), w)) {
    ++record.refined;
    record.rank = static_cast<int>(b.rows());
    record.unreachable = 0;
  } else {
    ++record.pinv;
    Matrix transposed(b.data(), b.cols(), b.rows());
    solve_orthogonal(transposed, r, Scratch(island.scratch), w, record);
  }
  w.array() *= root.array();
}

int take_scales(const Island& island) {
  const std::size_t columns = island.rows.mobility.size();
  const double floor_ratio = smallest_square(island.record->cutoff);
  int vanishing = 0;
  for (std::size_t i = 0; i < island.scale.size(); ++i) {
    double square = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      const double entry = island.rows.matrix[i * columns + j];
      square += entry * entry * island.rows.mobility[j];
    }
    double& scale = island.scale[i];
    const double smallest = scale > 0 ? vanishing_ratio / (scale * scale) : 0;
    if (std::isfinite(square) && square > smallest) {
      scale = 1 / std::sqrt(square);
      island.floor[i] = square > 1 / largest_plain_square && square < largest_plain_square
                            ? floor_ratio * square
                            : std::numeric_limits<double>::infinity();
    } else {
      ++vanishing;
      scale = scale > 0 ? scale : 1;
    }
  }
  return vanishing;
}

}  // namespace mbrt
