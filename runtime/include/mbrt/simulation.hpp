#pragma once
// `simulate`: the main program of every emitted simulation.

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "mbrt/any_model.hpp"
#include "mbrt/math.hpp"
#include "mbrt/model.hpp"
#include "mbrt/rk4.hpp"

namespace mbrt {

/// A model that remembers the first of its evaluations whose rate is not finite.
template <Model M>
struct StageProbe {
  using State = typename M::State;

  M& model;
  State state;
  double time = std::numeric_limits<double>::quiet_NaN();
  double now = 0;

  void set_time(double t) { model.set_time(now = t); }
  void rates(const State& y, State& rate) {
    model.rates(y, rate);
    if (std::isnan(time) && !all_finite(rate)) {
      time = now;
      state = y;
    }
  }
};

/// `M` behind the interface of AnyModel.
template <Model M>
class BoundModel final : public AnyModel {
 public:
  explicit BoundModel(M& model) : model_(model), state_(model.initial_state()), rate_(state_) {}

  const Description& description() const override { return model_.description(); }
  std::span<double> parameters() override { return model_.parameters(); }
  void prepare() override { model_.prepare(); }
  void initial_state(std::span<double> state) override { give(model_.initial_state(), state); }
  void set_time(double time) override { model_.set_time(time); }
  void rates(std::span<const double> state, std::span<double> rate) override {
    take(state, state_);
    model_.rates(state_, rate_);
    give(rate_, rate);
  }
  Island island([[maybe_unused]] int index) override {
    if constexpr (HasConstraints<M>) {
      return model_.island(index);
    } else {
      return {};
    }
  }
  void island_rows([[maybe_unused]] int index, std::span<const double> state) override {
    take(state, state_);
    if constexpr (HasConstraints<M>) {
      model_.island_rows(index, state_);
    }
  }
  void constraint_errors(std::span<const double> state, std::span<const double> rate,
                         [[maybe_unused]] std::span<double> position, [[maybe_unused]] std::span<double> velocity,
                         [[maybe_unused]] std::span<double> acceleration) override {
    take(state, state_);
    take(rate, rate_);
    if constexpr (HasConstraints<M>) {
      model_.constraint_errors(state_, rate_, position, velocity, acceleration);
    }
  }
  double energy(std::span<const double> state) override {
    take(state, state_);
    if constexpr (HasEnergy<M>) {
      return model_.energy(state_);
    } else {
      return 0;
    }
  }
  void outputs(std::span<const double> state, std::span<const double> rate,
               [[maybe_unused]] std::span<double> values) override {
    take(state, state_);
    take(rate, rate_);
    if constexpr (HasOutputs<M>) {
      model_.outputs(state_, rate_, values);
    }
  }
  void applied_forces(std::span<const double> state, [[maybe_unused]] std::span<double> values) override {
    take(state, state_);
    if constexpr (HasForces<M>) {
      model_.applied_forces(state_, values);
    }
  }

  void integrate(const TimeGrid& grid, std::span<double> state, Observer& observer) override {
    State y = state_;
    take(state, y);
    rk4(model_, y, grid, observer);
    give(y, state);
  }
  void integrate(const TimeGrid& grid, std::span<double> state) override {
    State y = state_;
    take(state, y);
    Unobserved nobody;
    rk4(model_, y, grid, nobody);
    give(y, state);
  }

  double find_failing_stage(double time, double step, std::span<double> state) override {
    State y = state_;
    take(state, y);
    StageProbe<M> probe{model_, y};
    Unobserved nobody;
    rk4(probe, y, {time, time + step, step, 1}, nobody);
    give(probe.state, state);
    model_.set_time(std::isnan(probe.time) ? time : probe.time);
    return probe.time;
  }

 private:
  using State = typename M::State;

  static void take(std::span<const double> from, State& to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = from[i];
    }
  }
  static void give(const State& from, std::span<double> to) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = from[i];
    }
  }

  M& model_;
  State state_;
  State rate_;
};

/// The main program of an emitted simulation; see `run_program`.
template <Model M>
int simulate(M& model, int argc, char** argv) {
  BoundModel<M> bound(model);
  return run_program(bound, argc, argv);
}

}  // namespace mbrt
