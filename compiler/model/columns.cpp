#include "model/columns.hpp"

#include <algorithm>

namespace mbcc::model {

std::vector<int> columns(const System& system) {
  std::vector<int> columns;
  for (const CoordinateId id : system.declared_coordinates) {
    columns.push_back(static_cast<int>(index(id)));
  }
  for (const SpeedId id : system.declared_speeds) {
    columns.push_back(static_cast<int>(system.coordinates.size() + index(id)));
  }
  return std::is_sorted(columns.begin(), columns.end()) ? std::vector<int>() : columns;
}

bool System::moves_plainly() const {
  bool plain = coordinates.size() == speeds.size();
  for (std::size_t i = 0; i < coordinates.size() && plain; ++i) {
    const std::optional<SpeedId> speed = speed_of(coordinates[i]);
    plain = speed && index(*speed) == i;
  }
  return plain;
}

}  // namespace mbcc::model
