#pragma once
// One island of a model: constraints and speeds that are solved together, apart from all others.
//
// Note [rank ladder]: the acceleration that the constraints add, c = M^-1 A^T z with (A M^-1 A^T) z = r, r = b - A a,
// is found on the cheapest step that is safe.
//   1. LDL^T of S = A M^-1 A^T, straight-line in the emitted code, as long as every pivot keeps
//      d_k >= max(plain_pivot_ratio * S_kk, floor_k). Two rows are solved by their determinant, d_2 S_11, or where
//      they have but two speeds by that of A, whose square it is and which condition does not square: there the ratio
//      may be smaller by 1e-8 (compiler/mechanics/eliminate.cpp).
//   2. LDL^T of the scaled rows and iterative refinement, residual in the factored form, while pivot ratios stay above
//      refined_pivot_ratio and rows ten times above the cut-off.
//   3. Complete orthogonal decomposition of the scaled A M^-1/2 with the explicit relative cut-off: the pinv.
// Steps 2 and 3 are `climb`, in the library. Rows are scaled by their size at the start, not at the state: a row that
// vanishes on the way must be seen to vanish, and a factor on a row must not matter.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace mbrt {

/// S squares the condition number: alone, LDL^T has relative error near eps / ratio, and 1e-4 keeps it at 1e-12.
/// Where more than two rows are solved together, two pivots may be small at once and the errors of both multiply: 1e-3
/// then keeps the error below 100 eps cond(A M^-1/2) (random scenes: a tenth of it, where 1e-4 may exceed it).
constexpr double plain_pivot_ratio(std::size_t rows) { return rows > 2 ? 1e-3 : 1e-4; }
/// Refinement converges while eps / ratio stays well below 1.
inline constexpr double refined_pivot_ratio = 1e-9;
/// floor_k relative to S_kk at the start: hands a row that vanishes to the pinv well before it reaches the cut-off.
inline constexpr double vanishing_ratio = 1e-12;
/// Singular values of the scaled A M^-1/2 below cut-off times the largest count as zero: between 1e-9, where parallel
/// rows are to be held redundant, and 1e-7, up to where accelerations are to be accurate.
inline constexpr double default_cutoff = 1e-8;
/// Singular values at this cut-off are a tenth of those that step 1 leaves alone: with a larger one it would decide.
inline constexpr double largest_cutoff = 1e-3;

/// Dense rows of one island at one state, row-major: `matrix` A (rows x columns), `residual` r = b - A a (rows),
/// `free` the acceleration a without constraints (columns), `mobility` 1/m (columns). `position` and `velocity` (rows)
/// are the errors of the constraints, in the units of their rows: value (0 where nonholonomic) and rate (there: value).
struct IslandRows {
  std::span<double> matrix;
  std::span<double> residual;
  std::span<double> free;
  std::span<double> mobility;
  std::span<double> position;
  std::span<double> velocity;

  void clear() const { std::fill(matrix.begin(), matrix.end(), 0.0); }
  /// Makes one row bind nothing.
  void ignore(std::size_t row) const {
    const std::span<double> entries = matrix.subspan(row * mobility.size(), mobility.size());
    std::fill(entries.begin(), entries.end(), 0.0);
    position[row] = velocity[row] = residual[row] = 0;
  }
};

/// What the solves of one island leave behind during a run.
struct IslandRecord {
  double cutoff = default_cutoff;  ///< a setting; all else is recorded
  int rank = 0;                    ///< found by the last `climb`
  double unreachable = 0;          ///< of the last `climb`: |part of r that A cannot reach| / |r|, rows scaled
  long refined = 0;                ///< evaluations that ended on step 2
  long pinv = 0;                   ///< and on step 3
};

/// View of an island's storage, which the model owns.
struct Island {
  std::span<double> scale;    ///< 1 / |A_k M^-1/2| at the start, per row
  std::span<double> floor;    ///< smallest pivot that step 1 accepts, per row, in the units of S_kk
  std::span<double> scratch;  ///< scratch_size(rows, columns) doubles for `climb`
  IslandRows rows;            ///< storage for rows at one state
  IslandRecord* record;
};

/// The condition of step 1 for one pivot of an island of so many rows. False for a NaN, which is then met in step 2.
constexpr bool holds(double pivot, double diagonal, double floor, std::size_t rows) {
  return pivot >= plain_pivot_ratio(rows) * diagonal && pivot >= floor;
}

/// The condition on which what the plain solve gives is good enough to start an iteration with: eps / ratio <= 1e-6.
constexpr bool nearly_holds(double pivot, double diagonal, double floor) {
  return pivot >= refined_pivot_ratio * diagonal && pivot >= floor;
}

constexpr std::size_t scratch_size(std::size_t rows, std::size_t columns) { return rows * rows + 6 * (rows + columns); }

/// Storage of an island whose size is known at compile time.
template <std::size_t Rows, std::size_t Columns>
class IslandStorage {
 public:
  IslandStorage() { record_.rank = static_cast<int>(Rows); }

  Island view() {
    return {scale_, floor_, scratch_, {matrix_, residual_, free_, mobility_, position_, velocity_}, &record_};
  }
  double floor(std::size_t row) const { return floor_[row]; }
  static constexpr bool holds(double pivot, double diagonal, double floor) {
    return mbrt::holds(pivot, diagonal, floor, Rows);
  }
  static constexpr bool nearly_holds(double pivot, double diagonal, double floor) {
    return mbrt::nearly_holds(pivot, diagonal, floor);
  }

 private:
  std::array<double, Rows> scale_{};
  std::array<double, Rows> floor_{};
  std::array<double, scratch_size(Rows, Columns)> scratch_{};
  std::array<double, Rows * Columns> matrix_{};
  std::array<double, Rows> residual_{};
  std::array<double, Columns> free_{};
  std::array<double, Columns> mobility_{};
  std::array<double, Rows> position_{};
  std::array<double, Rows> velocity_{};
  IslandRecord record_;
};

/// Steps 2 and 3 of Note [rank ladder]: `added[j]` becomes c_j, the acceleration that the constraints add to `free[j]`.
/// Reads and overwrites island.rows.
void climb(const Island& island, std::span<double> added);

/// Largest absolute value, at least 1: what distances in coordinates or in speeds are compared to.
double extent(std::span<const double> values);

/// `added` becomes the shortest displacement by mass that removes `errors` (island.rows.position or .velocity) from the
/// rows, as far as they can: Note [off the constraints] in src/correction.hpp. `size` is the extent of what is
/// displaced. Overwrites island.rows, and leaves no trace in the record.
void correct(const Island& island, std::span<const double> errors, double size, std::span<double> added);

/// Takes row scales and pivot floors from island.rows, the rows at the start. Returns the number of rows that vanish
/// there: rows that are zero, not finite or, where an earlier call has left a scale, smaller by vanishing_ratio than
/// the S_kk which that scale stands for. Their scale is left as it was, or set to 1 if there was none. The floors
/// depend on record->cutoff; those of rows whose S_kk cannot be multiplied with each other in a double are infinite.
int take_scales(const Island& island);

}  // namespace mbrt
