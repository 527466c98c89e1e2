#pragma once
// The System: a mechanical system in which every name is an id, every loop is unrolled and every rule of the language
// holds. It knows coordinates, speeds, inertia, forces, constraints and outputs, but not what a particle is.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "graph/operators.hpp"
#include "source/source.hpp"

namespace mbcc::model {

/// Index into System::expressions.
enum class ExpressionId : std::uint32_t {};
enum class CoordinateId : std::uint32_t {};
enum class SpeedId : std::uint32_t {};
enum class ParameterId : std::uint32_t {};

template <class Id>
constexpr std::uint32_t index(Id id) {
  return static_cast<std::uint32_t>(id);
}

enum class ExpressionKind : std::uint8_t {
  Number,      ///< `number`
  Time,        ///< t
  Coordinate,  ///< `index` is a CoordinateId
  Speed,       ///< `index` is a SpeedId
  Parameter,   ///< `index` is a ParameterId
  Apply,       ///< `op` applied to the first arity(op) `operands`
  Rate,        ///< total time derivative along the motion of operands[0]
};

/// A scalar expression. Operands come earlier in System::expressions than the node that uses them.
struct Expression {
  ExpressionKind kind = ExpressionKind::Number;
  graph::Operator op = graph::Operator::Add;
  std::uint32_t index = 0;
  double number = 0;
  std::array<ExpressionId, 3> operands{};
  Span span;
};

struct Coordinate {
  std::string name;      ///< "x1", "bob.x", "p[3].x"
  ExpressionId rate;     ///< its time derivative, of time, coordinates and speeds; in the simplest case a speed
  ExpressionId initial;  ///< in which coordinates and speeds stand for their starts
  Span span;
};

struct Speed {
  std::string name;          ///< "vx1", "bob.vx"
  std::string acceleration;  ///< "ax1", "bob.ax"
  ExpressionId inertia;      ///< the mass behind it, of numbers and parameters only; energies may add to it
  ExpressionId initial;
  Span span;
};

/// What moves and can be seen: three coordinates in space, two in the plane, one on a line.
struct Place {
  std::vector<CoordinateId> position;
};

/// One additive contribution to the applied forces.
struct Force {
  std::string name;    ///< for messages and summaries: "force on particle 1, x"
  ExpressionId along;  ///< the velocity that it acts along: its power is value * along
  ExpressionId value;
  Span span;
};

/// One term of the kinetic or of the potential energy.
struct Energy {
  ExpressionId value;
  Span span;
};

/// The statement in a loop or module that made a constraint, and the passes of the loops around it and around its part:
/// so that equal ones can be found again.
struct Template {
  Span statement;
  std::vector<long> indices;
};

/// value = 0. Holonomic if no speed occurs in it.
struct Constraint {
  std::string name;  ///< "sphere", "link[3]", "pin.x", or "constraint_K"
  ExpressionId value;
  bool holonomic = true;
  Span span;         ///< of the equation
  std::string text;  ///< the equation as the user wrote it, on one line
  std::optional<Template> made_by;
};

struct Parameter {
  std::string name;
  double value = 0;
  Span span;
};

struct Output {
  std::string name;
  ExpressionId value;
  Span span;
};

/// The `integrate` statement: defaults of the emitted program. Absent is absent.
struct Integration {
  std::optional<double> from, to, step, tolerance, every;
  std::optional<std::string> method;

  /// Whether runs choose their steps unless they are told otherwise: a step without a method means rk4.
  bool chooses_step() const { return method ? *method != "rk4" : !step; }
};

struct System {
  std::string name;  ///< of the `system` statement, or from the file's name
  int dimension = 3;
  std::vector<Expression> expressions;
  std::vector<Coordinate> coordinates;
  std::vector<Speed> speeds;
  std::vector<Place> places;
  std::vector<CoordinateId> declared_coordinates;  ///< in order of declaration: Note [storage order]
  std::vector<SpeedId> declared_speeds;
  /// Coordinates by index, then speeds behind them: every start comes after those that its expression needs.
  std::vector<std::size_t> start_order;
  std::vector<Parameter> parameters;
  std::vector<Force> forces;
  std::vector<Energy> kinetic;    ///< beside that of the speeds' own inertia
  std::vector<Energy> potential;  ///< beside that of constant forces
  std::vector<Constraint> constraints;
  std::vector<Output> outputs;
  Integration integration;

  const Expression& operator[](ExpressionId id) const { return expressions[index(id)]; }
  const Coordinate& operator[](CoordinateId id) const { return coordinates[index(id)]; }
  const Speed& operator[](SpeedId id) const { return speeds[index(id)]; }
  const Parameter& operator[](ParameterId id) const { return parameters[index(id)]; }

  /// The speed that is a coordinate's time derivative, if one is.
  std::optional<SpeedId> speed_of(const Coordinate& coordinate) const {
    const Expression& rate = (*this)[coordinate.rate];
    return rate.kind == ExpressionKind::Speed ? std::optional(SpeedId{rate.index}) : std::nullopt;
  }
  /// Whether every coordinate's time derivative is the speed of the same index.
  bool moves_plainly() const;
};

}  // namespace mbcc::model
