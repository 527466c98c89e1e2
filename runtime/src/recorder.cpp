#include "recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "records.hpp"

namespace mbrt {
namespace {

/// Whether two times are the same but for the rounding of from + i step.
bool same_time(double a, double b, double from) {
  return std::abs(a - b) <= 8 * std::numeric_limits<double>::epsilon() * (std::abs(a) + std::abs(from));
}

}  // namespace

std::vector<std::unique_ptr<RowFile>> open_recordings(const Description& model, const Options& options) {
  std::vector<std::unique_ptr<RowFile>> files;
  const std::vector<std::string> names = column_names(model, options.residuals);
  if (!options.csv.empty()) {
    files.push_back(std::make_unique<CsvFile>(options.csv, names));
  }
  if (!options.npy.empty()) {
    files.push_back(std::make_unique<NpyFile>(options.npy, names));
  }
  return files;
}

Recorder::Recorder(AnyModel& model, const Options& options, std::span<const std::unique_ptr<RowFile>> files)
    : model_(model),
      files_(files),
      maker_(model, options.residuals),
      from_(options.from),
      every_(options.every),
      islands_(islands_of(model)),
      last_state_(state_size(model.description())),
      last_rate_(last_state_.size()),
      between_state_(last_state_.size()),
      between_rate_(last_state_.size()) {}

void Recorder::accepted(double time, std::span<const double> state, std::span<const double> rate,
                        const Interpolant* between) {
  if (std::isnan(every_)) {
    write_row(time, state, rate);
    return;
  }
  write_between(time, state, rate, between);
  const double next = from_ + static_cast<double>(rows_) * every_;
  last_written_ = same_time(next, time, from_);
  if (last_written_) {
    ++rows_;
    model_.set_time(time);
    write_row(next, state, rate);
  }
  last_time_ = time;
  std::copy(state.begin(), state.end(), last_state_.begin());
  std::copy(rate.begin(), rate.end(), last_rate_.begin());
}

void Recorder::write_between(double time, std::span<const double> state, std::span<const double> rate,
                             const Interpolant* between) {
  for (;;) {
    const double next = from_ + static_cast<double>(rows_) * every_;
    if (!(next < time) || same_time(next, time, from_)) {
      return;
    }
    if (between != nullptr) {
      between->at(next, between_state_);
    } else {
      interpolate(next, time, state, rate);
    }
    model_.set_time(next);
    const Untraced untraced(islands_);
    model_.rates(between_state_, between_rate_);
    write_row(next, between_state_, between_rate_);
    ++rows_;
  }
}

void Recorder::interpolate(double at, double time, std::span<const double> state, std::span<const double> rate) {
  const double h = time - last_time_;
  const double s = (at - last_time_) / h;
  const double r = 1 - s;
  for (std::size_t i = 0; i < state.size(); ++i) {
    between_state_[i] = r * r * (1 + 2 * s) * last_state_[i] + s * s * (1 + 2 * r) * state[i] +
                        h * s * r * (r * last_rate_[i] - s * rate[i]);
  }
}

void Recorder::write_row(double time, std::span<const double> state, std::span<const double> rate) {
  const std::span<const double> row = maker_.row(time, state, rate);
  for (const auto& file : files_) {
    file->write_row(row);
  }
}

void Recorder::finish() {
  if (!last_written_) {
    model_.set_time(last_time_);
    write_row(last_time_, last_state_, last_rate_);
  }
}

}  // namespace mbrt
