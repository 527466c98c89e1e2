#include "recorder.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "records.hpp"

namespace mbrt {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

/// Names of elements of several indices hold commas.
void append_quoted(std::string& text, std::string_view name) {
  if (name.find_first_of(",\"") == std::string_view::npos) {
    text += name;
  } else {
    text += '"';
    text += name;
    text += '"';
  }
}

/// Whether two times are the same but for the rounding of from + i step.
bool same_time(double a, double b, double from) {
  return std::abs(a - b) <= 8 * std::numeric_limits<double>::epsilon() * (std::abs(a) + std::abs(from));
}

}  // namespace

Recorder::Recorder(AnyModel& model, OutputFile& file, double from, double every)
    : model_(model),
      file_(file),
      from_(from),
      every_(every),
      islands_(islands_of(model)),
      last_state_(state_size(model.description())),
      last_rate_(last_state_.size()),
      between_state_(last_state_.size()),
      between_rate_(last_state_.size()),
      outputs_(model.description().outputs.size()) {
  buffer_.reserve(2 * buffer_size);
  write_header();
}

void Recorder::write_header() {
  const Description& description = model_.description();
  buffer_ += 't';
  for (const auto names :
       {description.coordinates, description.speeds, description.accelerations, description.outputs}) {
    for (const char* const name : names) {
      buffer_ += ',';
      append_quoted(buffer_, name);
    }
  }
  buffer_ += '\n';
}

void Recorder::accepted(double time, std::span<const double> state, std::span<const double> rate) {
  if (std::isnan(every_)) {
    write_row(time, state, rate);
    return;
  }
  write_between(time, state, rate);
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

void Recorder::write_between(double time, std::span<const double> state, std::span<const double> rate) {
  for (;;) {
    const double next = from_ + static_cast<double>(rows_) * every_;
    if (!(next < time) || same_time(next, time, from_)) {
      return;
    }
    interpolate(next, time, state, rate);
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
  model_.outputs(state, rate, outputs_);
  write_number(time);
  for (const auto values :
       {state, rate.subspan(model_.description().coordinates.size()), std::span<const double>(outputs_)}) {
    for (const double value : values) {
      buffer_ += ',';
      write_number(value);
    }
  }
  buffer_ += '\n';
  flush_if_full();
}

void Recorder::write_number(double value) {
  constexpr int significant_digits = std::numeric_limits<double>::max_digits10;
  char digits[32];
  const auto [end, error] =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, significant_digits);
  buffer_.append(digits, end);
}

void Recorder::flush_if_full() {
  if (buffer_.size() >= buffer_size) {
    file_.write(buffer_);
    buffer_.clear();
  }
}

void Recorder::finish() {
  if (!last_written_) {
    model_.set_time(last_time_);
    write_row(last_time_, last_state_, last_rate_);
  }
  file_.write(buffer_);
  buffer_.clear();
}

}  // namespace mbrt
