#pragma once
// Models at chosen states, in the order of use that mbrt::Model asks for; the same for emitted classes and for the
// interpreter.

#include <algorithm>
#include <array>
#include <mbrt/dynamics.hpp>
#include <mbrt/model.hpp>
#include <mbrt/series.hpp>
#include <memory>
#include <span>
#include <vector>

namespace mbcc::test {

/// Brings `model` to its own start at `time`, row scales included, and returns the state there.
template <mbrt::Model M>
typename M::State start(M& model, double time = 0) {
  model.prepare();
  model.set_time(time);
  const typename M::State state = model.initial_state();
  if constexpr (mbrt::HasConstraints<M>) {
    for (int k = 0; k < static_cast<int>(model.description().islands.size()); ++k) {
      model.island_rows(k, state);
      mbrt::take_scales(model.island(k));
    }
  }
  return state;
}

/// Orders at which everything_at expands the motion: high, then low.
inline constexpr std::array<std::size_t, 2> expanded_orders = {12, 5};

/// The Taylor coefficients of the motion through a state, order by order from 1, for each of expanded_orders; nothing
/// where the model has no series there.
template <class M>
std::vector<double> coefficients_at(M& model, const typename M::State& state) {
  const auto series = std::make_unique<typename M::Series>();
  std::vector<double> all;
  for (const std::size_t order : expanded_orders) {
    if (!model.expand(state, order, *series)) {
      return {};
    }
    for (std::size_t k = 1; k <= order; ++k) {
      all.insert(all.end(), series->state[k].begin(), series->state[k].begin() + M::Series::size);
    }
  }
  return all;
}

/// The Jacobian of the rates at a state, column by column; nothing where it is not accurate there.
template <class M>
std::vector<double> jacobian_at(M& model, const typename M::State& state) {
  std::vector<double> columns;
  typename M::State direction = state, change = state;
  for (std::size_t j = 0; j < state.size(); ++j) {
    std::fill(direction.begin(), direction.end(), 0.0);
    direction[j] = 1;
    if (!model.tangent(state, direction, change)) {
      return {};
    }
    columns.insert(columns.end(), change.begin(), change.end());
  }
  return columns;
}

/// Everything that `model` computes at a state: its rate; then errors of constraints at position, velocity and
/// acceleration level, outputs, energy, applied forces, Taylor coefficients and Jacobian, where it has them.
template <mbrt::Model M>
std::vector<double> everything_at(M& model, double time, const typename M::State& state) {
  typename M::State rate = state;
  model.set_time(time);
  model.rates(state, rate);
  std::vector<double> all(rate.begin(), rate.end());
  const auto append = [&all](std::size_t count, const auto& fill) {
    std::vector<double> values(count);
    fill(std::span<double>(values));
    all.insert(all.end(), values.begin(), values.end());
  };
  const mbrt::Description& description = model.description();
  if constexpr (mbrt::HasConstraints<M>) {
    const std::size_t rows = description.constraints.size();
    append(3 * rows, [&](std::span<double> errors) {
      model.constraint_errors(state, rate, errors.first(rows), errors.subspan(rows, rows), errors.last(rows));
    });
  }
  if constexpr (mbrt::HasOutputs<M>) {
    append(description.outputs.size(), [&](std::span<double> values) { model.outputs(state, rate, values); });
  }
  if constexpr (mbrt::HasEnergy<M>) {
    append(description.has_energy ? 1 : 0, [&](std::span<double> values) {
      for (double& value : values) {
        value = model.energy(state);
      }
    });
  }
  if constexpr (mbrt::HasForces<M>) {
    append(description.forces.size(), [&](std::span<double> values) { model.applied_forces(state, values); });
  }
  if constexpr (mbrt::HasSeries<M>) {
    const std::vector<double> coefficients = coefficients_at(model, state);
    all.insert(all.end(), coefficients.begin(), coefficients.end());
  }
  if constexpr (mbrt::HasTangent<M>) {
    const std::vector<double> columns = description.has_tangent ? jacobian_at(model, state) : std::vector<double>();
    all.insert(all.end(), columns.begin(), columns.end());
  }
  return all;
}

}  // namespace mbcc::test
