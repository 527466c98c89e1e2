#pragma once
// Which rows are recorded of a motion.

#include <memory>
#include <span>
#include <vector>

#include "columns.hpp"
#include "mbrt/any_model.hpp"
#include "options.hpp"
#include "row_file.hpp"

namespace mbrt {

/// The files that a command line asks for, with their headers; each may have failed already.
std::vector<std::unique_ptr<RowFile>> open_recordings(const Description& model, const Options& options);

/// Writes a row of every column for each accepted state, or with `every` for the states at from + k every and, whether
/// on that grid or not, the last one. Rows between accepted states take the state from the method's own interpolant,
/// where it has none from the cubic one of Hermite, and accelerations and outputs from the model at that state.
class Recorder {
 public:
  /// The files must outlive the recorder.
  Recorder(AnyModel& model, const Options& options, std::span<const std::unique_ptr<RowFile>> files);

  /// Each accepted state in turn, the start first. May change the model's time.
  void accepted(double time, std::span<const double> state, std::span<const double> rate, const Interpolant* between);

  /// After the last state.
  void finish();

 private:
  void write_row(double time, std::span<const double> state, std::span<const double> rate);
  void write_between(double time, std::span<const double> state, std::span<const double> rate,
                     const Interpolant* between);
  void interpolate(double at, double time, std::span<const double> state, std::span<const double> rate);

  AnyModel& model_;
  const std::span<const std::unique_ptr<RowFile>> files_;
  RowMaker maker_;
  const double from_;
  const double every_;
  const std::vector<Island> islands_;
  long rows_ = 0;             // on the grid of `every`
  bool last_written_ = true;  // the last accepted state has its row
  double last_time_ = 0;
  std::vector<double> last_state_, last_rate_;
  std::vector<double> between_state_, between_rate_;
};

}  // namespace mbrt
