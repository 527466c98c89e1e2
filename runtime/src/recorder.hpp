#pragma once
// The motion as rows of comma-separated values.

#include <span>
#include <string>
#include <vector>

#include "mbrt/any_model.hpp"
#include "output_file.hpp"

namespace mbrt {

/// Writes a header (`t`, positions, velocities, accelerations, outputs) and then rows with 17 significant digits: each
/// accepted state, or with `every` the states at from + k every and, whether on that grid or not, the last one. Rows
/// between accepted states take the state from the cubic Hermite interpolant, and accelerations and outputs from the
/// model at that state.
class Recorder {
 public:
  Recorder(AnyModel& model, OutputFile& file, double from, double every);

  /// Each accepted state in turn, the start first. May change the model's time.
  void accepted(double time, std::span<const double> state, std::span<const double> rate);

  /// After the last state.
  void finish();

 private:
  void write_header();
  void write_row(double time, std::span<const double> state, std::span<const double> rate);
  void write_number(double value);
  void write_between(double time, std::span<const double> state, std::span<const double> rate);
  void interpolate(double at, double time, std::span<const double> state, std::span<const double> rate);
  void flush_if_full();

  AnyModel& model_;
  OutputFile& file_;
  const double from_;
  const double every_;
  const std::vector<Island> islands_;
  long rows_ = 0;             // on the grid of `every`
  bool last_written_ = true;  // the last accepted state has its row
  double last_time_ = 0;
  std::vector<double> last_state_, last_rate_;
  std::vector<double> between_state_, between_rate_, outputs_;
  std::string buffer_;
};

}  // namespace mbrt
