#pragma once
// What is recorded of a motion: the names of the columns, and a row of them at a state.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// Indices into the state in order of declaration, coordinates first: Description::columns, written out.
std::vector<std::size_t> declared_order(const Description& model);

/// Of a coordinate or a speed, by its index in the state.
const char* state_name(const Description& model, std::size_t i);

/// `t`, positions, velocities, accelerations and outputs; with `residuals` also the errors of every constraint
/// (`rod.position_error` where it is holonomic, `rod.velocity_error`, `rod.acceleration_error`), and `energy` where it
/// is known.
std::vector<std::string> column_names(const Description& model, bool residuals);

/// Makes rows in the order of `column_names`.
class RowMaker {
 public:
  RowMaker(AnyModel& model, bool residuals);

  /// The row at a state; the model's time must be `time`. Valid until the next call.
  std::span<const double> row(double time, std::span<const double> state, std::span<const double> rate);

 private:
  void append_residuals(std::span<const double> state, std::span<const double> rate);

  AnyModel& model_;
  const bool residuals_;
  const std::vector<std::size_t> order_;
  std::vector<double> outputs_, position_, velocity_, acceleration_;
  std::vector<double> row_;
};

}  // namespace mbrt
