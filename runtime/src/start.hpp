#pragma once
// The state and the row scales that a run starts from.

#include <string>
#include <vector>

#include "mbrt/any_model.hpp"
#include "options.hpp"

namespace mbrt {

/// Sets the parameters and returns the model's own start with the values of the command line.
std::vector<double> start_state(AnyModel& model, const Options& options);

/// Which elements of the state assembling holds: what the command line fixes or gives a value.
std::vector<bool> held_elements(const Options& options, std::size_t size);

/// Sets the model's time to `time` and takes the row scales and pivot floors of all islands there. A row that vanishes
/// at the start has the scale of the rows a little way off, in state and time.
void take_row_scales(AnyModel& model, const std::vector<Island>& islands, double time,
                     const std::vector<double>& state);

/// One message per constraint that `state` violates, at the model's time; empty for a consistent start.
std::string find_inconsistencies(AnyModel& model, const std::vector<Island>& islands, const std::vector<double>& state);

}  // namespace mbrt
