#pragma once
// Speeds that inertia does not couple.
//
// Note [uncoupled speeds]: M = L D L^T, L unit lower triangular in the order of elimination, factored symbolically with
// what is structurally zero left out. In the speeds w = L^T u the inertia is D: constraint rows become A L^-T, forces
// L^-1 f, and all that solves constraints works on these as if each speed had a mass of its own. Back: u = L^-T w, one
// speed after the other, the last eliminated first,
//   u_j = w_j - sum over i of L_ij u_i.
// Where M is diagonal, L is 1 and nothing of this exists.
//
// A speed s without inertia needs a row of A that determines it. With M + a_s^-2 A_r^T A_r in place of M, r that row,
// the constrained motion is the same (Udwadia and Schutte; Orsino 2016, F11 iii), and s is eliminated first, without
// rounding: L_is = A_ri / A_rs, D_s = 1, and b_r / A_rs joins its free acceleration.

#include <optional>
#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/energies.hpp"
#include "mechanics/point.hpp"

namespace mbcc::mechanics {

struct Uncoupled {
  std::vector<Coupling> couplings;        ///< in order of elimination
  std::vector<Expr> inertia;              ///< nv, D
  std::vector<Expr> free;                 ///< nv, D^-1 L^-1 f
  std::vector<std::vector<Entry>> rows;   ///< of A L^-T
  std::vector<std::size_t> undetermined;  ///< speeds with neither inertia nor a row that could determine them
};

/// `start` tells which entries of rows are not zero.
Uncoupled uncouple(const InertiaMatrix& inertia, std::vector<Expr> forces, const std::vector<Row>& rows,
                   const Point& start);

/// The speeds u of uncoupled ones: `values`, one per speed, or nothing where it is not asked for.
std::vector<Expr> coupled(const std::vector<Coupling>& couplings, std::vector<Expr> values);

/// The other way round: w = L^T u.
std::vector<Expr> uncoupled(const std::vector<Coupling>& couplings, std::vector<Expr> values);

}  // namespace mbcc::mechanics
