#pragma once
// The methods by name.

#include <span>
#include <string_view>
#include <vector>

#include "mbrt/any_model.hpp"
#include "options.hpp"

namespace mbrt {

struct MethodEntry {
  const char* name;
  const char* description;
  bool chooses_step;
};

std::span<const MethodEntry> methods();

/// Null if there is none of that name.
const MethodEntry* find_method(std::string_view name);

/// Moves `state` by the method of the options: with the model's own code where it has what the options ask for, else
/// with that of the library. Without an observer nothing is watched.
Course integrate(AnyModel& model, const std::vector<Island>& islands, const Options& options, const Task& task,
                 std::vector<double>& state, Observer* observer);

/// Repeats one step of rk4 from `state` and leaves there the first stage whose rate is not finite. Returns its time,
/// which is then the time of the model, or NaN if every stage is finite.
double find_failing_stage(AnyModel& model, double time, double step, std::span<double> state);

}  // namespace mbrt
