#pragma once
// What the runtime knows of a model: its state, its functions and its names. Emitted classes prove that they satisfy
// the concept `Model`; so does mbcc's interpreter, whose sizes are known at run time only.

#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>

#include "mbrt/island.hpp"

namespace mbrt {

/// Emitted code asserts that it was made for this version of these headers.
inline constexpr int interface_version = 2;

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

struct ParameterEntry {
  const char* name;
  double value;  ///< the model's default
};

/// `place` is "file.mbd:12", the line of the model.
struct ConstraintEntry {
  const char* name;
  const char* place;
  bool holonomic;
};
struct ForceEntry {
  const char* name;
  const char* place;
};
/// Constraints and speeds, as indices into those of the model, that one solve determines together.
struct IslandEntry {
  std::span<const int> constraints;
  std::span<const int> speeds;
};

/// The model's `integrate` statement; `not_given` and nullptr where it is silent.
struct Defaults {
  double from = not_given;
  double to = not_given;
  double step = not_given;
  double tolerance = not_given;
  double every = not_given;
  const char* method = nullptr;
};

/// Names and structure of a model, for messages, columns and summaries. Points to static storage.
struct Description {
  const char* model;         ///< the model's name
  const char* mbcc_version;  ///< of the compiler that emitted it
  std::span<const char* const> coordinates;
  std::span<const char* const> speeds;
  std::span<const char* const> accelerations;  ///< one per speed
  std::span<const char* const> outputs;
  std::span<const ParameterEntry> parameters;
  std::span<const ConstraintEntry> constraints;
  std::span<const ForceEntry> forces;
  std::span<const IslandEntry> islands;
  bool has_energy;  ///< applied forces are constant or absent, so that kinetic and potential energy are known
  bool has_series;  ///< emitted with the recurrences of its Taylor series: method `taylor`
  Defaults defaults;
  /// Indices into the state, coordinates first, in order of declaration, which is that of columns of results. Empty
  /// where the state has that order too.
  std::span<const int> columns = {};
  bool has_tangent = false;  ///< emitted with derivatives of its rates: method `radau`
};

/// A mechanical system as functions of its state y = (coordinates, speeds), an indexable range of doubles.
///
/// Order of use: set `parameters()`, then `prepare()`; `set_time(t)` and take the row scales of each island at the
/// start; then any number of `set_time(t)` and evaluations. Evaluations depend on the parameters, the time set, the
/// state and the row scales, and on nothing else. None allocates.
template <class M>
concept Model = requires(M& model, const typename M::State& state, typename M::State& rate, double time) {
  { model.description() } -> std::same_as<const Description&>;
  { model.parameters() } -> std::same_as<std::span<double>>;
  model.prepare();                                               // after a change of parameters
  { model.initial_state() } -> std::same_as<typename M::State>;  // the model's own start
  model.set_time(time);                                          // what depends on time alone
  model.rates(state, rate);                                      // rate = d state / dt
};

// What a model has beyond that depends on its scene: a scene without constraints has no islands, one without outputs
// no function for them. `description()` tells which of the following there are.

template <class M>
concept HasConstraints = requires(M& model, const typename M::State& state, std::span<double> values, int island) {
  { model.island(island) } -> std::same_as<Island>;
  model.island_rows(island, state);  // fills island(k).rows at `state`
  // Per constraint: value (untouched where nonholonomic), its time derivative (there: its value), and A u' - b.
  model.constraint_errors(state, state, values, values, values);
};
/// Islands are solved for speeds that inertia does not couple (Note [uncoupled speeds],
/// compiler/mechanics/uncouple.hpp). The second argument holds changes in the place of the speeds; the last one begins
/// as a copy of these, and what is coupled is replaced: by the changes of the speeds themselves, and the other way
/// round.
template <class M>
concept HasCoupledInertia = requires(M& model, const typename M::State& state, std::span<double> values) {
  model.couple(state, state, values);
  model.uncouple(state, state, values);
};
/// How the coordinates move with displacements along the speeds, which the second argument holds in the place of the
/// speeds. A model without this has a speed for each coordinate, its rate.
template <class M>
concept HasKinematics = requires(M& model, const typename M::State& state, std::span<double> values) {
  model.move(state, state, values);
};
template <class M>
concept HasEnergy = requires(M& model, const typename M::State& state) {
  { model.energy(state) } -> std::same_as<double>;
};
template <class M>
concept HasOutputs = requires(M& model, const typename M::State& state, std::span<double> values) {
  model.outputs(state, state, values);
};
template <class M>
concept HasForces = requires(M& model, const typename M::State& state, std::span<double> values) {
  model.applied_forces(state, values);  // one value per entry of description().forces
};

}  // namespace mbrt
