#pragma once
// The equations of what the rates of a motion change by when its state does.
//
// Note [tangent]: A u' = b and u' = a + M^-1 A^T z hold at every state. So do their derivatives along a direction (dq,
// du) of the state,
//   A du' = db - dA u',   du' = da + d(M^-1 A^T) z + M^-1 A^T dz,
// with u' and z the accelerations and multipliers at the state: equations of the same form for du', whose right sides
// alone are others. `eliminate` solves them with the factors that it has for u'. In uncoupled speeds (Note [uncoupled
// speeds], uncouple.hpp), where u' = L^-T w', A and M^-1 are those of w', and du' = L^-T (dw' - dL^T u'): the last term
// joins da, and A times it db. The direction is a value of the program, so that the code is linear in the size of the
// model, and gives the Jacobian column by column.

#include <vector>

#include "mechanics/derivatives.hpp"
#include "mechanics/eliminate.hpp"

namespace mbcc::mechanics {

struct Tangent {
  std::vector<Expr> kinematics;  ///< nq, dq'
  Derivatives equations;         ///< as above: free and b are those of du'
};

/// `solutions` are the eliminations of u', by island.
Tangent differentiate_along_direction(const Equations& equations, const Derivatives& derivatives,
                                      const std::vector<const Elimination*>& solutions);

}  // namespace mbcc::mechanics
