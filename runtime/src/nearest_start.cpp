#include "mbrt/nearest_start.hpp"

#include "assemble.hpp"
#include "records.hpp"
#include "start.hpp"

namespace mbrt {

std::vector<double> nearest_start(AnyModel& model, double time) {
  const std::vector<Island> islands = islands_of(model);
  const Description& description = model.description();
  std::vector<double> state(description.coordinates.size() + description.speeds.size());
  model.prepare();
  model.initial_state(state);
  take_row_scales(model, islands, time, state);
  assemble(model, islands, std::vector<bool>(state.size()), state);
  take_row_scales(model, islands, time, state);
  return find_inconsistencies(model, islands, state).empty() ? state : std::vector<double>();
}

}  // namespace mbrt
