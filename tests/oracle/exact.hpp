#pragma once
// The equation of motion in quadruple precision: u' = a + M^-1/2 (A M^-1/2)^+ (b - A a), island by island, from the
// differentiated equations alone. Nothing of elimination, lowering or emission is in it.
//
// Note [rounded rows]: double precision does not have B = A M^-1/2, r = b - A a and a, but B + dB, r + dr and a + da.
// A solve without any error of its own then differs in w = B^+ r, to first order (Wedin), by
//   dw = B^+ (dr - dB w) + (1 - B^+ B) dB^T (B B^T)^+ r + B^+ B^+T dB^T (r - B w),
// and in M^1/2 u' = M^1/2 a + w by no more than
//   |M^1/2 da| + (|dr| + 2 |dB| |w| + |dB| |r - B w| / s) / s,    s the smallest singular value that is kept,
// since (B B^T)^+ r = B^+T w. The sizes of dB, dr and da are those of the terms that cancel in them, which may be much
// larger than the results: support/tracked.hpp adds them up.

#include <vector>

#include "driver/compile.hpp"
#include "runtime/quad_pinv.hpp"

namespace mbcc::test {

using mbrt::test::Quad;

/// One island at one state. Sizes and errors are in the norm |M^1/2 u'|.
struct ExactIsland {
  std::vector<std::size_t> components;  ///< of the state, that its speeds are
  std::vector<Quad> acceleration;       ///< u', per speed of the island
  std::vector<Quad> inertia;
  double size = 0;       ///< of u'
  double parts = 0;      ///< of a and of what the constraints add, which may cancel
  double condition = 1;  ///< of the scaled rows, without what the cut-off drops
  // By how much u' may differ between programs
  double truncation = 0;      ///< that drop different singular values below the cut-off
  double contradiction = 0;   ///< that weigh differently constraints which contradict each other at this state
  double rounding = 0;        ///< that round the rows: Note [rounded rows]
  bool is_deficient = false;  ///< rows depend on others
  bool is_ambiguous = false;  ///< a singular value is within a factor of ten of the cut-off
};

class ExactModel {
 public:
  explicit ExactModel(const Compilation& compilation);

  /// `state` is coordinates, then speeds.
  std::vector<ExactIsland> at(double time, const std::vector<double>& state) const;

 private:
  struct Rows;
  Rows rows_at(const mechanics::Island& island, const std::vector<std::size_t>& rows, double time,
               const std::vector<double>& state) const;
  std::vector<std::size_t> all_rows(const mechanics::Island& island) const;
  ExactIsland solve(std::size_t island, double time, const std::vector<double>& state) const;

  const Compilation& compilation_;
  std::vector<std::vector<Quad>> scales_;  ///< per island and row, from the start
};

/// |M^1/2 (u' - exact)| over the island's speeds; `rate` begins with the rate of a state, q' and u'.
double distance(const ExactIsland& island, const std::vector<double>& rate);

}  // namespace mbcc::test
