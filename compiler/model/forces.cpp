#include <fmt/format.h>

#include <algorithm>

#include "model/names.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {

void SystemBuilder::add_force(const Particle& particle, const ast::Expression& expression, const Frame* frame) {
  const Operand force{evaluator_.evaluate(expression, frame), expression.span};
  const std::string what = "the force on " + describe(particle);
  const Value components =
      expect_independent(force, Quantities::Acceleration, what) ? expect_vector(force, what) : Value();
  for (std::size_t axis = 0; axis < components.size(); ++axis) {
    add_force("force", particle, axis, components[axis], component_span(expression, axis));
  }
}

void SystemBuilder::add_force(std::string_view kind, const Particle& particle, std::size_t axis, const Scalar& value,
                              Span span) {
  if (value.is_zero()) {
    return;
  }
  const std::string where = context_.dimension == 1 ? "" : fmt::format(", {}", axis_names[axis]);
  const ExpressionId along = speed_node(context_.motion_index(particle, axis), span);
  system_.forces.push_back(
      {fmt::format("{} on {}{}", kind, describe(particle), where), along, context_.arena.node(value, span), span});
}

/// A generalized force: what times the rate of the variable is its power.
void SystemBuilder::add_force(const Variable& variable, const ast::Expression& expression, const Frame* frame) {
  const Operand force{evaluator_.evaluate(expression, frame), expression.span};
  const std::string what = fmt::format("the force on `{}`", variable.name);
  if (evaluator_.algebra().expect_number(force, what) && expect_independent(force, Quantities::Acceleration, what)) {
    const ExpressionId along = variable.has_speed() ? speed_node(variable.speed, expression.span)
                                                    : system_.coordinates[variable.coordinate].rate;
    system_.forces.push_back({fmt::format("force on `{}`", variable.name), along,
                              context_.arena.node(force.value[0], expression.span), expression.span});
  }
}

void SystemBuilder::add(const ast::ForceOn& force, const Instance& instance) {
  const Evaluator::Target target = evaluator_.target(force.target, instance.frame);
  if (target.particle != nullptr) {
    add_force(*target.particle, force.value, instance.frame);
  } else if (target.point != nullptr) {
    add_force(*target.point, force, instance.frame);
  } else if (target.variable != nullptr) {
    add_force(*target.variable, force.value, instance.frame);
  } else {
    evaluator_.evaluate(force.value, instance.frame);  // for what is wrong with it
  }
}

/// Each component acts along that of the point's velocity.
void SystemBuilder::add_force(Definition& point, const ast::ForceOn& force, const Frame* frame) {
  const std::string what = fmt::format("force on `{}`", point.name);
  const Operand applied{evaluator_.evaluate(force.value, frame), force.value.span};
  const Value components = expect_independent(applied, Quantities::Acceleration, "the " + what)
                               ? expect_vector(applied, "the " + what)
                               : Value();
  const Value position = evaluator_.value_of(point, force.target.span);
  for (std::size_t axis = 0; axis < std::min(components.size(), position.size()); ++axis) {
    const Scalar velocity = context_.arena.rate(position[axis], force.value.span);
    if (!components[axis].is_zero() && velocity.node) {
      const std::string where = context_.dimension == 1 ? "" : fmt::format(", {}", axis_names[axis]);
      const Span span = component_span(force.value, axis);
      system_.forces.push_back({what + where, *velocity.node, context_.arena.node(components[axis], span), span});
    }
  }
}

void SystemBuilder::add(const ast::Gravity& gravity, const Instance& instance) {
  const Operand field{evaluator_.evaluate(gravity.value, instance.frame), gravity.value.span};
  const Quantities motion = Quantities::Coordinate | Quantities::Speed | Quantities::Acceleration;
  const Value components = expect_independent(field, motion, "gravity") ? expect_vector(field, "gravity") : Value();
  if (components.is_nothing() || context_.report.found_errors() || instance.frame->scope->is_part()) {
    return;  // a mass may be missing; and a part hangs in the field of the whole
  }
  for (const Particle& particle : context_.symbols.particles) {
    for (std::size_t axis = 0; axis < components.size(); ++axis) {
      const Span span = component_span(gravity.value, axis);
      const Scalar mass = context_.arena.scalar(system_.speeds[context_.motion_index(particle, axis)].inertia);
      const Value weight = evaluator_.algebra().multiply({mass, span}, {components[axis], span}, span, span);
      if (!weight.is_nothing()) {
        add_force("gravity", particle, axis, weight[0], span);
      }
    }
  }
}

}  // namespace mbcc::model
