#pragma once
// The differentiated equations: A u' = b, the free acceleration, and what they are made of: sparsity, islands, the
// order in which each island is eliminated.

#include <optional>
#include <string>
#include <vector>

#include "mechanics/equations.hpp"

namespace mbcc::mechanics {

/// A structurally nonzero entry of a matrix in the column of one speed.
struct Entry {
  std::size_t speed;
  Expr value;
};

/// One constraint, differentiated until the accelerations appear linearly: A_k u' = b_k (paper.md, Udwadia and Kalaba
/// 1992).
struct Row {
  std::size_t constraint;
  std::vector<Entry> entries;  ///< of A, the derivatives of the constraint along speeds, by increasing speed
  std::vector<Entry> solved;   ///< of A L^-T: the row in uncoupled speeds, which is what the solve uses
  Expr b;                      ///< holonomic: -d2h/dt2 at u' = 0; nonholonomic: -dg/dt at u' = 0
  Expr value;                  ///< h or g
  Expr rate;                   ///< dh/dt along the motion; g where nonholonomic
  Expr residual;               ///< b - A a
  double content = 1;          ///< numeric factor that all entries share; the solve uses the row divided by it
};

/// How a speed u_j follows from uncoupled ones: Note [uncoupled speeds] in uncouple.hpp.
struct Coupling {
  std::size_t speed;
  std::vector<Entry> terms;  ///< L_ij
};

/// `value`, an entry or the residual of `row`, of the row as it is solved: divided by its content.
inline Expr as_solved(const Row& row, Expr value) { return value / number(value, row.content); }

/// Rows and speeds that have to be solved together: a connected component of the graph that A and M make of the speeds.
struct Island {
  std::vector<std::size_t> rows;    ///< in elimination order
  std::vector<std::size_t> held;    ///< rows that the others imply: Note [held rows] in redundancy.hpp
  std::vector<std::size_t> speeds;  ///< increasing
};

struct Derivatives {
  std::vector<Expr> free;           ///< nv, a = M^-1 f, of islands along uncoupled speeds
  std::vector<Expr> inertia;        ///< nv, the diagonal of M; 1 where a constraint determines a speed
  std::vector<Expr> mobility;       ///< nv, 1/m, of uncoupled speeds
  std::vector<Coupling> couplings;  ///< of speeds in islands
  std::vector<Row> rows;            ///< one per constraint, in order
  std::vector<Island> islands;
  std::vector<std::size_t> undetermined;  ///< speeds with neither inertia nor a constraint that could determine them
  std::optional<Expr>
      energy;  ///< kinetic and potential, where the model declares one or every applied force is constant
};

/// A speed in an island whose uncoupled inertia or coupling changes during a run: constraints then have no series of
/// constant matrices. Nothing where there is none.
std::optional<std::size_t> find_changing_inertia(const Derivatives& derivatives);

/// Differentiates by duals over the graph: one direction per entry of A, the motion itself, twice, for b.
Derivatives differentiate(const model::System& system, const Equations& equations, graph::Graph& graph);

}  // namespace mbcc::mechanics
