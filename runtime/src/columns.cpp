#include "columns.hpp"

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

}  // namespace

std::vector<std::string> column_names(const Description& model, bool residuals) {
  std::vector<std::string> names{"t"};
  for (const auto group : {model.coordinates, model.speeds, model.accelerations, model.outputs}) {
    names.insert(names.end(), group.begin(), group.end());
  }
  if (residuals) {
    append_residual_names(names, model);
  }
  return names;
}

RowMaker::RowMaker(AnyModel& model, bool residuals)
    : model_(model),
      residuals_(residuals),
      outputs_(model.description().outputs.size()),
      position_(residuals ? model.description().constraints.size() : 0),
      velocity_(position_.size()),
      acceleration_(position_.size()) {}

std::span<const double> RowMaker::row(double time, std::span<const double> state, std::span<const double> rate) {
  model_.outputs(state, rate, outputs_);
  const std::span<const double> accelerations = rate.subspan(model_.description().coordinates.size());
  row_.assign(1, time);
  row_.insert(row_.end(), state.begin(), state.end());
  row_.insert(row_.end(), accelerations.begin(), accelerations.end());
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
