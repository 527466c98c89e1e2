#include <fmt/format.h>

#include "model/names.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {
namespace {

constexpr Quantities motion = Quantities::Coordinate | Quantities::Speed | Quantities::Acceleration;

std::string column(const Particle& particle, std::string_view prefix, std::size_t axis) {
  return particle.number > 0 ? fmt::format("{}{}{}", prefix, axis_names[axis], particle.number)
                             : fmt::format("{}.{}{}", particle.name, prefix, axis_names[axis]);
}

}  // namespace

void SystemBuilder::add_particles() {
  std::vector<Fields> fields;
  const std::size_t size = context_.symbols.particles.size() * static_cast<std::size_t>(context_.dimension);
  system_.coordinates.resize(size);
  system_.speeds.resize(size);
  for (const Particle& particle : context_.symbols.particles) {
    const Reporter::Within within(context_.report, particle.frame->scope->trace);
    fields.push_back(fields_of("particle", particle.syntax->fields, {"mass", "position", "velocity", "force"}));
    Place& place = system_.places.emplace_back();
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(context_.dimension); ++axis) {
      const std::uint32_t index = context_.motion_index(particle, axis);
      const Span span = particle.syntax->name.span;
      for (const std::string_view prefix : {"", "v", "a"}) {
        motion_columns_.insert(column(particle, prefix, axis));
      }
      place.position.push_back(CoordinateId{index});
      system_.coordinates[index] = {column(particle, "", axis), speed_node(index, span), {}, span};
      system_.speeds[index] = {column(particle, "v", axis), column(particle, "a", axis), {}, {}, span};
      system_.declared_coordinates.push_back(CoordinateId{index});
      system_.declared_speeds.push_back(SpeedId{index});
    }
  }
  for (const Particle& particle : context_.symbols.particles) {
    const Reporter::Within within(context_.report, particle.frame->scope->trace);
    add_motion(particle, fields[particle.position]);
  }
  for (const Particle& particle : context_.symbols.particles) {
    const Reporter::Within within(context_.report, particle.frame->scope->trace);
    if (const auto force = fields[particle.position].find("force"); force != fields[particle.position].end()) {
      add_force(particle, force->second->value, particle.frame);
    }
  }
}

void SystemBuilder::add_motion(const Particle& particle, const Fields& fields) {
  const auto field = [&](std::string_view name) {
    const auto found = fields.find(name);
    return found == fields.end() ? nullptr : found->second;
  };
  const ExpressionId mass = mass_of(particle, field("mass"));
  const Quantities never = Quantities::Time | Quantities::Acceleration;
  const Value position = start_of(particle, field("position"), "position", never | Quantities::Speed);
  const Value velocity =
      field("velocity") ? start_of(particle, field("velocity"), "velocity", never) : expect_vector({0.0, {}}, "");
  const auto dimension = static_cast<std::size_t>(context_.dimension);
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    Coordinate& coordinate = system_.coordinates[context_.motion_index(particle, axis)];
    Speed& speed = system_.speeds[context_.motion_index(particle, axis)];
    speed.inertia = mass;
    if (!position.is_nothing()) {
      coordinate.span = component_span(field("position")->value, axis);
      coordinate.initial = context_.arena.node(position[axis], coordinate.span);
    }
    if (!velocity.is_nothing()) {
      speed.span = field("velocity") ? component_span(field("velocity")->value, axis) : speed.span;
      speed.initial = context_.arena.node(velocity[axis], speed.span);
    }
  }
}

void SystemBuilder::report_missing(const Particle& particle, std::string_view field) {
  if (!context_.report.is_damaged(particle.statement)) {
    context_.report.report(Finding::MissingField, particle.syntax->name.span, describe(particle), field, field);
  }
}

/// Positions and velocities in a start are those at the start: order_starts().
Value SystemBuilder::start_of(const Particle& particle, const ast::Field* field, std::string_view what,
                              Quantities unwanted) {
  if (field == nullptr) {
    report_missing(particle, what);
    return {};
  }
  const Operand start{evaluator_.evaluate(field->value, particle.frame), field->value.span};
  const std::string of = fmt::format("the initial {} of {}", what, describe(particle));
  return expect_independent(start, unwanted, of) ? expect_vector(start, of) : Value();
}

/// Its value is checked where the parameters have their defaults: others are the run's affair.
ExpressionId SystemBuilder::mass_of(const Particle& particle, const ast::Field* field) {
  if (field == nullptr) {
    report_missing(particle, "mass");
    return {};
  }
  const Operand mass{evaluator_.evaluate(field->value, particle.frame), field->value.span};
  const std::string of = "the mass of " + describe(particle);
  if (!evaluator_.algebra().expect_number(mass, of) || !expect_independent(mass, motion | Quantities::Time, of)) {
    return {};
  }
  const ExpressionId id = context_.arena.node(mass.value[0], mass.span);
  const std::optional<double> value = value_at_defaults(context_.arena, system_.parameters, id);
  if (value && !(*value > 0)) {
    context_.report.report(Finding::MassNotPositive, mass.span, describe(particle), *value);
  }
  return id;
}

}  // namespace mbcc::model
