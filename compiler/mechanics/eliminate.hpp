#pragma once
// Symbolic LDL^T of S = A M^-1 A^T of one island, rows divided by their content, in the island's elimination order: the
// plain step of the rank ladder (runtime/include/mbrt/island.hpp, Note [rank ladder]) as expressions.

#include <vector>

#include "mechanics/derivatives.hpp"

namespace mbcc::mechanics {

/// The pivot of one row beside the diagonal entry that it started from: the ratio of the two tells how safe it is.
struct Pivot {
  std::size_t row;
  Expr diagonal;  ///< S_kk
  Expr pivot;     ///< d_k
  Expr scale;     ///< of both: 1, or what both were multiplied by to save a division
};

struct Elimination {
  // In the order of the model, row by row: first what rows have alone, then what couples them, so that both can be
  // computed for many rows at once.
  std::vector<std::vector<Expr>> rows;              ///< r_k, S_kk
  std::vector<std::vector<Expr>> couplings;         ///< S_kl for each earlier l, for every k that has one
  std::vector<Pivot> pivots;                        ///< in elimination order
  std::vector<Expr> forward;                        ///< y of L y = r, in elimination order
  std::vector<Expr> quotients;                      ///< y_k / d_k, which do not wait for one another
  std::vector<Expr> multipliers;                    ///< z of S z = r, in elimination order
  std::vector<std::vector<Expr>> constraint_terms;  ///< M^-1 A_k^T z_k per row, in the order of the model
  std::vector<Expr> accelerations;                  ///< u' = a + M^-1 A^T z per speed of the island
};

/// The right-hand sides of an island's rows as solved, in elimination order.
struct RightSides {
  std::vector<Expr> b;         ///< of A u' = b
  std::vector<Expr> residual;  ///< b - A a
};

/// Whether the rows alone determine the accelerations, so that `eliminate` reads b of the right-hand sides; it reads
/// the residuals otherwise.
bool rows_determine(const Island& island);

/// The solve of the accelerations at a state.
Elimination eliminate(const Island& island, const Derivatives& derivatives, graph::Graph& graph);

/// The same matrix with other right-hand sides.
Elimination eliminate(const Island& island, const Derivatives& derivatives, const RightSides& right,
                      graph::Graph& graph);

}  // namespace mbcc::mechanics
