#pragma once
// The equations of a System as expressions of one graph.

#include <cstdint>
#include <vector>

#include "graph/graph.hpp"
#include "model/system.hpp"

namespace mbcc::mechanics {

using graph::Expr;

/// q' = kinematics, M u' = sum of forces (+ constraint forces), constraints = 0. M and a part of the forces follow from
/// the energies: energies.hpp. Vectors run over coordinates
/// (nq), speeds (nv), forces, constraints and outputs in the System's order.
struct Equations {
  std::vector<Expr> initial_coordinates;  ///< nq, of parameters
  std::vector<Expr> initial_speeds;       ///< nv, of parameters
  std::vector<Expr> kinematics;           ///< nq, q' in (t, q, u)
  std::vector<Expr> inertia;              ///< nv, the masses on the diagonal of M, of parameters
  std::vector<Expr> forces;               ///< one per model::Force
  std::vector<Expr> force_velocities;     ///< what each acts along
  std::vector<Expr> kinetic;              ///< terms in (t, q, q', u), q' as leaves where it is no speed
  std::vector<Expr> potential;            ///< terms in (t, q)
  std::vector<Expr> constraints;          ///< h(t, q), or g(t, q, u) where nonholonomic
  std::vector<Expr> outputs;              ///< in (t, q, u, u')
};

/// Expresses `system` in `graph`. Total derivatives (postfix prime) become derivatives along the motion.
Equations formulate(const model::System& system, graph::Graph& graph);

/// The derivative of each expression along the motion q' = kinematics, u' = accelerations (Acceleration leaves).
std::vector<Expr> rates_of(const std::vector<Expr>& expressions, const std::vector<Expr>& kinematics);

}  // namespace mbcc::mechanics
