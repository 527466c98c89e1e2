#include <fmt/format.h>

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
  const SpeedId speed{context_.motion_index(particle, axis)};
  system_.forces.push_back(
      {fmt::format("{} on {}{}", kind, describe(particle), where), speed, context_.arena.node(value, span), span});
}

void SystemBuilder::add(const ast::ForceOn& force, const Instance& instance) {
  const Particle* particle = evaluator_.particle(force.target, instance.frame);
  if (particle != nullptr) {
    add_force(*particle, force.value, instance.frame);
  } else {
    evaluator_.evaluate(force.value, instance.frame);  // for what is wrong with it
  }
}

void SystemBuilder::add(const ast::Gravity& gravity, const Instance& instance) {
  const Operand field{evaluator_.evaluate(gravity.value, instance.frame), gravity.value.span};
  const Quantities motion = Quantities::Coordinate | Quantities::Speed | Quantities::Acceleration;
  const Value components = expect_independent(field, motion, "gravity") ? expect_vector(field, "gravity") : Value();
  if (components.is_nothing() || context_.report.found_errors()) {
    return;  // a mass may be missing
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
