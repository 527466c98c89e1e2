#include "start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "constraint_distance.hpp"
#include "records.hpp"

namespace mbrt {
namespace {

/// Mistyped starts are off by more, and rounded ones (`0.7071068`) by less.
constexpr double start_tolerance = 1e-6;

void take_scales_at(AnyModel& model, const std::vector<Island>& islands, const std::vector<double>& state) {
  for (std::size_t k = 0; k < islands.size(); ++k) {
    model.island_rows(static_cast<int>(k), state);
    take_scales(islands[k]);
  }
}

/// The i-th of a sequence of numbers between -0.05 and 0.05 without any regularity: fractional parts of multiples of
/// the golden ratio.
double offset(std::size_t i) {
  constexpr double golden = 1.618033988749895;
  const double multiple = static_cast<double>(i) * golden;
  return 0.1 * (multiple - std::floor(multiple) - 0.5);
}

std::vector<double> displaced(const Description& model, std::vector<double> state) {
  const std::span<double> all = state;
  std::size_t i = 0;
  for (const auto part : {all.first(model.coordinates.size()), all.subspan(model.coordinates.size())}) {
    const double size = extent(part);
    for (double& value : part) {
      value += size * offset(++i);
    }
  }
  return state;
}

}  // namespace

std::vector<double> start_state(AnyModel& model, const Options& options) {
  for (const Assignment& parameter : options.parameters) {
    model.parameters()[parameter.index] = parameter.value;
  }
  model.prepare();
  std::vector<double> state(state_size(model.description()));
  model.initial_state(state);
  for (const Assignment& initial : options.initial) {
    state[initial.index] = initial.value;
  }
  return state;
}

std::vector<bool> held_elements(const Options& options, std::size_t size) {
  std::vector<bool> held(size);
  for (const Assignment& initial : options.initial) {
    held[initial.index] = true;
  }
  for (const std::size_t index : options.fixed) {
    held[index] = true;
  }
  return held;
}

void take_row_scales(AnyModel& model, const std::vector<Island>& islands, double time,
                     const std::vector<double>& state) {
  model.set_time(time + offset(0));
  take_scales_at(model, islands, displaced(model.description(), state));
  model.set_time(time);
  take_scales_at(model, islands, state);
}

std::string find_inconsistencies(AnyModel& model, const std::vector<Island>& islands,
                                 const std::vector<double>& state) {
  const Description& description = model.description();
  const std::span<const double> all = state;
  const double reach = start_tolerance * extent(all.first(description.coordinates.size()));
  const double speed = start_tolerance * extent(all.subspan(description.coordinates.size()));
  std::vector<double> position(description.constraints.size()), velocity(position), unused(position);
  const std::vector<double> no_rate(state.size());
  model.constraint_errors(state, no_rate, position, velocity, unused);
  std::string messages;
  for (std::size_t k = 0; k < islands.size(); ++k) {
    model.island_rows(static_cast<int>(k), state);
    for (std::size_t row = 0; row < islands[k].scale.size(); ++row) {
      const auto index = static_cast<std::size_t>(description.islands[k].constraints[row]);
      const ConstraintEntry& entry = description.constraints[index];
      const IslandRows& rows = islands[k].rows;
      const double norm = row_norm(rows, row);
      if (const double off = entry.holonomic ? distance(rows.position[row], norm) : 0; off > reach) {
        fmt::format_to(std::back_inserter(messages),
                       "{}: error: the start violates constraint `{}`: its value is {:.6g}, {:.3g} away from zero in "
                       "the coordinates\n",
                       entry.place, entry.name, position[index], off);
      } else if (const double fast = distance(rows.velocity[row], norm); fast > speed) {
        fmt::format_to(std::back_inserter(messages),
                       "{}: error: the initial velocities violate constraint `{}`: {} is {:.6g}, {:.3g} away from zero "
                       "in the speeds\n",
                       entry.place, entry.name, entry.holonomic ? "its rate" : "its value", velocity[index], fast);
      }
    }
  }
  return messages;
}

}  // namespace mbrt
