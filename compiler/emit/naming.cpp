#include "emit/naming.hpp"

#include <fmt/format.h>

#include <array>

namespace mbcc::cpp {

using graph::Kind;

std::string Naming::name_of_leaf(Kind kind, std::uint32_t index) const {
  switch (kind) {
    case Kind::Coordinate:
      return coordinates[index];
    case Kind::Speed:
      return speeds[index];
    case Kind::CoordinateChange:
      return coordinate_changes[index];
    case Kind::SpeedChange:
      return speed_changes[index];
    case Kind::Acceleration:
      return accelerations[index];
    case Kind::Parameter:
      return parameters[index];
    case Kind::Order:
      return fmt::format("order_{}", index);
    case Kind::InverseOrder:
      return fmt::format("inverse_{}", index);
    case Kind::Impulse:
      return fmt::format("impulse_{}", index);
    default:
      return "t";
  }
}

namespace {

std::string source_of_row(Kind kind, const std::string& index) {
  constexpr std::array arrays = {"left", "right", "slow_left", "slow_right", "squares", "slow_squares"};
  constexpr std::array rows = {"1", "k - 1", "k", "k + 1"};
  const std::size_t at = static_cast<std::size_t>(kind) - static_cast<std::size_t>(Kind::LeftFirst);
  return fmt::format("s.{}[{}][{}]", arrays[at / rows.size()], rows[at % rows.size()], index);
}

}  // namespace

std::string Naming::source_of_leaf(Kind kind, const std::string& index) {
  if (is_row(kind)) {
    return source_of_row(kind, index);
  }
  switch (kind) {
    case Kind::Coordinate:
    case Kind::Speed:
      return fmt::format("y[{}]", index);
    case Kind::CoordinateChange:
    case Kind::SpeedChange:
      return fmt::format("direction[{}]", index);
    case Kind::Acceleration:
      return fmt::format("rate[{}]", index);
    case Kind::Parameter:
      return fmt::format("parameters_[{}]", index);
    case Kind::StateNow:
      return fmt::format("s.state[k][{}]", index);
    case Kind::StateNext:
      return fmt::format("s.state[k + 1][{}]", index);
    case Kind::FreeNow:
      return fmt::format("s.free[{}]", index);
    case Kind::ProductSum:
      return fmt::format("s.product_sums[{}]", index);
    case Kind::SlowProductSum:
      return fmt::format("s.slow_product_sums[{}]", index);
    case Kind::SquareSum:
      return fmt::format("s.square_sums[{}]", index);
    case Kind::SlowSquareSum:
      return fmt::format("s.slow_square_sums[{}]", index);
    case Kind::Order:
      return fmt::format("mbrt::order_numbers[k + {}]", index);
    case Kind::InverseOrder:
      return fmt::format("mbrt::inverse_orders[k + {}]", index);
    case Kind::Impulse:
      return fmt::format("k + {} == 1 ? 1.0 : 0.0", index);
    default:
      return "t_";
  }
}

std::size_t Naming::offset_of(Kind kind) const {
  return kind == Kind::Speed || kind == Kind::SpeedChange || kind == Kind::Acceleration ? coordinates.size() : 0;
}

Naming make_naming(const model::System& system, const program::Program& program) {
  Naming naming;
  for (const model::Coordinate& coordinate : system.coordinates) {
    naming.coordinates.push_back(naming.scope.declare(coordinate.name));
  }
  for (const model::Speed& speed : system.speeds) {
    naming.speeds.push_back(naming.scope.declare(speed.name));
    naming.accelerations.push_back(naming.scope.declare(speed.acceleration));
  }
  if (program.tangent) {
    for (const std::string& coordinate : naming.coordinates) {
      naming.coordinate_changes.push_back(naming.scope.declare("d_" + coordinate));
    }
    for (const std::string& speed : naming.speeds) {
      naming.speed_changes.push_back(naming.scope.declare("d_" + speed));
    }
  }
  for (const model::Parameter& parameter : system.parameters) {
    naming.parameters.push_back(naming.scope.declare(parameter.name));
  }
  for (const program::Kernel* kernel : {&program.prepare, &program.time}) {
    for (const program::NodeId id : kernel->provides) {
      const auto named = program.names.find(id);
      const std::string name = named != program.names.end()
                                   ? naming.scope.declare(named->second)
                                   : naming.scope.enumerate(kernel == &program.time ? "t" : "p");
      naming.members.emplace(id, name + "_");
    }
  }
  naming.keeps_time = program.keeps_time;
  return naming;
}

}  // namespace mbcc::cpp
