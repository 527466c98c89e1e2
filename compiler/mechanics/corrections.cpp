#include "mechanics/corrections.hpp"

namespace mbcc::mechanics {

Derivatives corrections(const Derivatives& derivatives, const model::System& system, ErrorLevel level,
                        graph::Graph& graph) {
  Derivatives result = derivatives;
  result.free.assign(derivatives.free.size(), graph.constant(0));
  for (Row& row : result.rows) {
    row.b = -(level == ErrorLevel::Position ? row.value : row.rate);
    row.residual = row.b;
  }
  for (Island& island : result.islands) {
    std::erase_if(island.rows, [&](std::size_t row) {
      return level == ErrorLevel::Position && !system.constraints[derivatives.rows[row].constraint].holonomic;
    });
  }
  return result;
}

}  // namespace mbcc::mechanics
