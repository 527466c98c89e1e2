#include "emit/targets.hpp"

#include "diagnostics/assert.hpp"

namespace mbcc::cpp {

using program::Target;

std::string_view array_of(Target target) {
  switch (target) {
    case Target::Initial:
      return "y";
    case Target::Rate:
      return "rate";
    case Target::Matrix:
      return "rows.matrix";
    case Target::Residual:
      return "rows.residual";
    case Target::Free:
      return "rows.free";
    case Target::Mobility:
      return "rows.mobility";
    case Target::RowPosition:
      return "rows.position";
    case Target::RowVelocity:
      return "rows.velocity";
    case Target::Position:
      return "position";
    case Target::Velocity:
      return "velocity";
    case Target::Acceleration:
      return "acceleration";
    case Target::Output:
    case Target::Force:
      return "values";
    case Target::Energy:
      break;
  }
  MBCC_ASSERT(target != Target::Energy);
  return {};
}

}  // namespace mbcc::cpp
