#pragma once
// Inertia and generalized forces that follow from energies.
//
// Note [energies]: with T(t, q, q', u) and V(t, q), and q' = q'(t, q, u), d'Alembert's principle in the form of
// Jourdain gives for each speed u_j
//   d/dt dT/du_j + sum over i of K_ij (d/dt dT/dq'_i - dT/dq_i + dV/dq_i) = F_j,   K_ij = dq'_i/du_j
// (Orsino 2016, A.2 and A.6). What multiplies u' is the inertia matrix M, and the rest, taken at u' = 0, a force. A
// coordinate whose rate is a speed has that speed for q'_i: its column of K is one. In a term that is written with
// other speeds these count as rates of what nobody asks for, which is right where K is constant; elsewhere the rates of
// coordinates have to be used instead (examine.cpp).

#include <map>
#include <vector>

#include "mechanics/equations.hpp"

namespace mbcc::mechanics {

/// The inertia matrix by rows: symmetric, structurally nonzero entries.
using InertiaMatrix = std::vector<std::map<std::size_t, Expr>>;

struct EnergyTerms {
  InertiaMatrix inertia;     ///< the speeds' own included
  std::vector<Expr> forces;  ///< nv
};

EnergyTerms differentiate_energies(const Equations& equations, graph::Graph& graph);

}  // namespace mbcc::mechanics
