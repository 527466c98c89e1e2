#pragma once
// `simulate`: the main program of every emitted simulation.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "mbrt/any_model.hpp"
#include "mbrt/model.hpp"

namespace mbrt {

/// Copies between a model's own states and spans.
template <class State>
void take(std::span<const double> from, State& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = from[i];
  }
}
template <class State>
void give(const State& from, std::span<double> to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] = from[i];
  }
}

/// An `Observer` as a method for states of its own type wants it.
template <class State>
class Relay {
 public:
  explicit Relay(Observer& observer) : observer_(observer) {}

  void arriving() { observer_.arriving(); }
  bool accepted(double time, const State& state, const State& rate) {
    return observer_.accepted(time, state, rate, nullptr);
  }
  template <class Between>
  bool accepted(double time, const State& state, const State& rate, const Between& between) {
    const Bridge<Between> bridge(between, state);
    return observer_.accepted(time, state, rate, &bridge);
  }

 private:
  template <class Between>
  class Bridge final : public Interpolant {
   public:
    Bridge(const Between& between, const State& like) : between_(between), like_(like) {}
    void at(double time, std::span<double> state) const override {
      State y = like_;
      between_(time, y);
      give(y, state);
    }

   private:
    const Between& between_;
    const State& like_;
  };

  Observer& observer_;
};

/// The series of a model, or nothing.
template <class M>
struct SeriesStorage {
  struct Type {};
};
template <HasSeries M>
struct SeriesStorage<M> {
  using Type = typename M::Series;
};

/// `M` behind the interface of AnyModel, with methods (Rk4, Dop853, ...) compiled for it.
template <Model M, class... Methods>
class BoundModel final : public AnyModel {
 public:
  explicit BoundModel(M& model) : model_(model), state_(model.initial_state()), rate_(state_), direction_(state_) {}

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
  void couple(std::span<const double> state, std::span<const double> rate, std::span<double> changes) override {
    take_change(state, rate, changes);
    if constexpr (HasCoupledInertia<M>) {
      model_.couple(state_, rate_, changes);
    }
  }
  void uncouple(std::span<const double> state, std::span<const double> rate, std::span<double> changes) override {
    take_change(state, rate, changes);
    if constexpr (HasCoupledInertia<M>) {
      model_.uncouple(state_, rate_, changes);
    }
  }
  void move(std::span<const double> state, std::span<const double> rate, std::span<double> moved) override {
    take_change(state, rate, moved);
    if constexpr (HasKinematics<M>) {
      model_.move(state_, rate_, moved);
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

  std::optional<Coefficients> expand([[maybe_unused]] std::span<const double> state,
                                     [[maybe_unused]] std::size_t order) override {
    if constexpr (HasSeries<M>) {
      series_.resize(1);
      take(state, state_);
      return model_.expand(state_, order, series_[0]) ? std::optional(series_[0].coefficients()) : std::nullopt;
    } else {
      return std::nullopt;
    }
  }

  bool tangent([[maybe_unused]] std::span<const double> state, [[maybe_unused]] std::span<const double> direction,
               [[maybe_unused]] std::span<double> change) override {
    if constexpr (HasTangent<M>) {
      take(state, state_);
      take(direction, direction_);
      const bool is_accurate = model_.tangent(state_, direction_, rate_);
      give(rate_, change);
      return is_accurate;
    } else {
      return false;
    }
  }

  bool has_code_for(std::string_view method) const override { return ((method == Methods::name) || ...); }
  bool can_project() const override { return Projectable<M> || !HasConstraints<M>; }
  Course integrate(std::string_view method, const Task& task, std::span<double> state, Observer& observer) override {
    Relay<State> relay(observer);
    return run(method, task, state, relay);
  }
  Course integrate(std::string_view method, const Task& task, std::span<double> state) override {
    Unobserved nobody;
    return run(method, task, state, nobody);
  }

 private:
  using State = typename M::State;

  void take_change(std::span<const double> state, std::span<const double> rate, std::span<double> change) {
    take(state, state_);
    take(rate, rate_);
    const std::span<const double> of_speeds = rate.subspan(model_.description().coordinates.size());
    std::copy_n(of_speeds.begin(), std::min(of_speeds.size(), change.size()), change.begin());
  }

  template <class AnyObserver>
  Course run(std::string_view method, const Task& task, std::span<double> state, AnyObserver& observer) {
    State y = state_;
    take(state, y);
    Course course;
    static_cast<void>(((method == Methods::name && (course = Methods::run(model_, y, task, observer), true)) || ...));
    give(y, state);
    return course;
  }

  M& model_;
  State state_;
  State rate_;
  State direction_;
  std::vector<typename SeriesStorage<M>::Type> series_;  ///< one, when it is first asked for
};

/// The main program of an emitted simulation; see `run_program`.
template <class... Methods, Model M>
int simulate(M& model, int argc, char** argv) {
  BoundModel<M, Methods...> bound(model);
  return run_program(bound, argc, argv);
}

}  // namespace mbrt
