#pragma once
// The one seam between the templates of the runtime and its precompiled part: a model whose type has been forgotten.

#include <optional>
#include <span>
#include <string_view>

#include "mbrt/dynamics.hpp"
#include "mbrt/island.hpp"
#include "mbrt/model.hpp"
#include "mbrt/series.hpp"

namespace mbrt {

/// The states within the step that has just been accepted.
class Interpolant {
 public:
  virtual void at(double time, std::span<double> state) const = 0;

 protected:
  ~Interpolant() = default;
};

/// A step observer (dynamics.hpp) of precompiled code. `between` is null where the method has no dense output.
class Observer {
 public:
  virtual void arriving() = 0;
  virtual bool accepted(double time, std::span<const double> state, std::span<const double> rate,
                        const Interpolant* between) = 0;

 protected:
  ~Observer() = default;
};

/// The functions of a `Model`, with states as spans of coordinates().size() + speeds().size() doubles.
class AnyModel {
 public:
  virtual const Description& description() const = 0;
  virtual std::span<double> parameters() = 0;
  virtual void prepare() = 0;
  virtual void initial_state(std::span<double> state) = 0;
  virtual void set_time(double time) = 0;
  virtual void rates(std::span<const double> state, std::span<double> rate) = 0;
  virtual Island island(int index) = 0;
  virtual void island_rows(int index, std::span<const double> state) = 0;
  virtual void constraint_errors(std::span<const double> state, std::span<const double> rate,
                                 std::span<double> position, std::span<double> velocity,
                                 std::span<double> acceleration) = 0;
  /// The changes of speeds that those of uncoupled ones stand for, the other way round, and the displacement of the
  /// coordinates that one along the speeds stands for: `rate` holds what is given in the place of the speeds.
  virtual void couple(std::span<const double> state, std::span<const double> rate, std::span<double> changes) = 0;
  virtual void uncouple(std::span<const double> state, std::span<const double> rate, std::span<double> changes) = 0;
  virtual void move(std::span<const double> state, std::span<const double> rate, std::span<double> moved) = 0;
  virtual double energy(std::span<const double> state) = 0;
  virtual void outputs(std::span<const double> state, std::span<const double> rate, std::span<double> values) = 0;
  virtual void applied_forces(std::span<const double> state, std::span<double> values) = 0;

  /// Taylor coefficients of the motion through `state`, valid until the next call; nothing where there are none.
  virtual std::optional<Coefficients> expand(std::span<const double> state, std::size_t order) = 0;

  /// The derivative of the rates along a direction: HasTangent in dynamics.hpp.
  virtual bool tangent(std::span<const double> state, std::span<const double> direction, std::span<double> change) = 0;

  /// Whether a method was compiled for this very model. The library has the others, for any model.
  virtual bool has_code_for(std::string_view method) const = 0;
  /// Whether such code can project: the model has code for it, or nothing to project onto.
  virtual bool can_project() const = 0;
  /// Moves `state` as the task says, by a method that the model has code for.
  virtual Course integrate(std::string_view method, const Task& task, std::span<double> state, Observer& observer) = 0;
  virtual Course integrate(std::string_view method, const Task& task, std::span<double> state) = 0;

 protected:
  ~AnyModel() = default;
};

/// The emitted program: reads the command line, runs the model, writes what was asked for; returns the exit code
/// (0 fine, 2 wrong usage or unwritable output, 3 run-time failure, 130 interrupted).
int run_program(AnyModel& model, int argc, char** argv);

}  // namespace mbrt
