#include "columns.hpp"

#include <numeric>

#include "records.hpp"

namespace mbrt {
namespace {

void append_residual_names(std::vector<std::string>& names, const Description& model) {
  for (const ConstraintEntry& constraint : model.constraints) {
    const std::string name = constraint.name;
    if (constraint.holonomic) {
      names.push_back(name + ".position_error");
    }
    names.push_back(name + ".velocity_error");
    names.push_back(name + ".acceleration_error");
  }
  if (model.has_energy) {
    names.emplace_back("energy");
  }
}

/// The speeds of declared_order().
std::span<const std::size_t> speeds_of(std::span<const std::size_t> order, const Description& model) {
  return order.subspan(model.coordinates.size());
}

}  // namespace

std::vector<std::size_t> declared_order(const Description& model) {
  std::vector<std::size_t> order(model.columns.begin(), model.columns.end());
  if (order.empty()) {
    order.resize(state_size(model));
    std::iota(order.begin(), order.end(), std::size_t{0});
  }
  return order;
}

const char* state_name(const Description& model, std::size_t i) {
  const std::size_t coordinates = model.coordinates.size();
  return i < coordinates ? model.coordinates[i] : model.speeds[i - coordinates];
}

std::vector<std::string> column_names(const Description& model, bool residuals) {
  std::vector<std::string> names{"t"};
  const std::vector<std::size_t> order = declared_order(model);
  for (const std::size_t i : order) {
    names.emplace_back(state_name(model, i));
  }
  for (const std::size_t i : speeds_of(order, model)) {
    names.emplace_back(model.accelerations[i - model.coordinates.size()]);
  }
  names.insert(names.end(), model.outputs.begin(), model.outputs.end());
  if (residuals) {
    append_residual_names(names, model);
  }
  return names;
}

RowMaker::RowMaker(AnyModel& model, bool residuals)
    : model_(model),
      residuals_(residuals),
      order_(declared_order(model.description())),
      outputs_(model.description().outputs.size()),
      position_(residuals ? model.description().constraints.size() : 0),
      velocity_(position_.size()),
      acceleration_(position_.size()) {}

std::span<const double> RowMaker::row(double time, std::span<const double> state, std::span<const double> rate) {
  model_.outputs(state, rate, outputs_);
  row_.assign(1, time);
  for (const std::size_t i : order_) {
    row_.push_back(state[i]);
  }
  for (const std::size_t i : speeds_of(order_, model_.description())) {
    row_.push_back(rate[i]);
  }
  row_.insert(row_.end(), outputs_.begin(), outputs_.end());
  if (residuals_) {
    append_residuals(state, rate);
  }
  return row_;
}

void RowMaker::append_residuals(std::span<const double> state, std::span<const double> rate) {
  const Description& description = model_.description();
  model_.constraint_errors(state, rate, position_, velocity_, acceleration_);
  for (std::size_t i = 0; i < description.constraints.size(); ++i) {
    if (description.constraints[i].holonomic) {
      row_.push_back(position_[i]);
    }
    row_.push_back(velocity_[i]);
    row_.push_back(acceleration_[i]);
  }
  if (description.has_energy) {
    row_.push_back(model_.energy(state));
  }
}

}  // namespace mbrt
