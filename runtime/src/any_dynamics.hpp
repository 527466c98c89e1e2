#pragma once
// A model as the integrators of the library take it, with what a run adds to its equations.

#include <optional>
#include <vector>

#include "correction.hpp"
#include "mbrt/any_model.hpp"
#include "options.hpp"

namespace mbrt {

/// Projection onto the constraints, and Baumgarte's stabilization: instead of h'' = 0 the accelerations then satisfy
/// h'' + 2 b1 b2 h' + b2^2 h = 0, and g' + b3 g = 0 where a constraint is nonholonomic. They change by what removes the
/// added terms, as errors of velocity are removed from speeds.
class AnyDynamics {
 public:
  using State = std::vector<double>;

  AnyDynamics(AnyModel& model, const std::vector<Island>& islands, const std::optional<Stabilization>& stabilization)
      : model_(model), correction_(model, islands), stabilization_(stabilization) {}

  const Description& description() const { return model_.description(); }
  Island island(int index) { return model_.island(index); }
  void set_time(double time) { model_.set_time(time); }

  void rates(const State& y, State& rate) {
    model_.rates(y, rate);
    if (stabilization_) {
      stabilize(y, rate);
    }
  }

  using Series = Coefficients;
  bool expand(const State& y, std::size_t order, Series& series) {
    const std::optional<Coefficients> expanded = model_.expand(y, order);
    series = expanded.value_or(Coefficients{});
    return expanded.has_value();
  }

  /// Not of the equations that a stabilization makes.
  bool tangent(const State& y, const State& direction, State& change) {
    return !stabilization_ && model_.tangent(y, direction, change);
  }

  /// One step of Newton's method for the coordinates, then one for the speeds.
  void project(State& y) {
    const std::span<double> all = y;
    const std::size_t coordinates = model_.description().coordinates.size();
    add(correction_.coordinates_of(y, correction_.step(errors_of_position, y)), all.first(coordinates));
    add(correction_.step(errors_of_velocity, y), all.subspan(coordinates));
  }

 private:
  void stabilize(const State& y, State& rate) {
    const auto [b1, b2, b3] = *stabilization_;
    const ErrorTerms terms = {b2 * b2, 2 * b1 * b2, b3};
    add(correction_.step(terms, y), std::span(rate).subspan(model_.description().coordinates.size()));
  }

  static void add(std::span<const double> change, std::span<double> values) {
    for (std::size_t j = 0; j < change.size(); ++j) {
      values[j] += change[j];
    }
  }

  AnyModel& model_;
  Correction correction_;
  const std::optional<Stabilization> stabilization_;
};

}  // namespace mbrt
