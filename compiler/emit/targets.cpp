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
    case Target::Change:
      return "change";
    case Target::Shift:
      return "shift";
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
    case Target::CoordinateFirst:
      return "s.state[1]";
    case Target::SwitchStart:
      return "s.switches[0]";
    case Target::SwitchNow:
      return "s.switches[k]";
    case Target::FreeNow:
      return "s.free";
    case Target::LeftNext:
      return "s.left[k + 1]";
    case Target::LeftNow:
      return "s.left[k]";
    case Target::RightNext:
      return "s.right[k + 1]";
    case Target::RightLate:
      return "s.right[k + 2]";
    case Target::SlowLeftNow:
      return "s.slow_left[k]";
    case Target::SlowRightNow:
      return "s.slow_right[k]";
    case Target::SquareNext:
      return "s.squares[k + 1]";
    case Target::SlowSquareNow:
      return "s.slow_squares[k]";
    case Target::SpeedNext:
      return "s.state[k + 1]";
    case Target::CoordinateLate:
      return "s.state[k + 2]";
    case Target::Energy:
      break;
  }
  MBCC_ASSERT(target != Target::Energy);
  return {};
}

std::string_view climb_of(program::Unknowns unknowns) {
  switch (unknowns) {
    case program::Unknowns::Accelerations:
      return "climb";
    case program::Unknowns::Displacements:
      return "climb_to_position";
    case program::Unknowns::SpeedChanges:
      return "climb_to_velocity";
    case program::Unknowns::Tangents:  // refuse
      break;
  }
  return {};
}

}  // namespace mbcc::cpp
