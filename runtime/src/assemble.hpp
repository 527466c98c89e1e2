#pragma once
// The nearest consistent start.

#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// Moves `state` to the nearest one that satisfies all constraints at the model's time, where distances count by mass:
/// the coordinates first, then the speeds with the coordinates as they then are. Elements of the state that `held`
/// marks stay. Where there is no such state it ends as near to one as it gets; `find_inconsistencies` tells.
///
/// Note [nearest start]: one constraint error h at a state q is removed to first order by the displacement
/// M^-1 A^T (A M^-1 A^T)^+ (-h), the shortest one by mass (Gauss-Newton). Repeated, it reaches the constraints, but not
/// quite at the point nearest to where it began. That point is where the displacement d from the beginning has no part
/// along the constraints: d = M^-1 A^T (A M^-1 A^T)^+ (A d - h), with A and h at the moved state, which is solved by
/// iteration.
void assemble(AnyModel& model, const std::vector<Island>& islands, const std::vector<bool>& held,
              std::vector<double>& state);

}  // namespace mbrt
