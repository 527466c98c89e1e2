// What a force acts on, and what `kinematics` and `equation` are about.

#include <fmt/format.h>

#include "model/evaluator.hpp"

namespace mbcc::model {

Evaluator::Target Evaluator::target(const ast::Expression& target, const Frame* frame) {
  const auto* reference = std::get_if<Reference>(&target.node);
  const ast::Step* step = reference != nullptr && reference->steps.size() == 1 ? &reference->steps[0] : nullptr;
  const bool is_index = step != nullptr && step->indices.empty() && find_index(frame, step->name) != nullptr;
  if (is_index || std::holds_alternative<ast::Number>(target.node)) {
    return numbered_target(target, frame);
  }
  const Symbol* symbol = step != nullptr ? frame->scope->find(step->name) : nullptr;
  if (symbol != nullptr && symbol->kind == SymbolKind::Constraint) {
    context_.report.report(Finding::ForceTarget, target.span, fmt::format("`{}` is a constraint", step->name));
    return {};
  }
  const Base found = base(*reference, frame);
  if (found.particle != nullptr && found.steps == reference->steps.size()) {
    return {found.particle};
  }
  if (found.definition != nullptr && is_position(found.definition->kind) && found.steps == reference->steps.size()) {
    return {nullptr, found.definition};
  }
  const bool is_variable = found.variable != nullptr && found.steps == reference->steps.size();
  if (is_variable && !found.variable->is_state()) {
    return {nullptr, nullptr, found.variable};
  }
  const bool is_whole = found.definition != nullptr && found.steps == reference->steps.size();
  if (found.definition != nullptr || found.particle != nullptr || found.part != nullptr || found.variable != nullptr) {
    const std::string_view is = found.part != nullptr ? describe(SymbolKind::Part)
                                : is_variable         ? describe(SymbolKind::State)
                                : is_whole            ? describe(found.definition->kind)
                                                      : "none";
    context_.report.report(Finding::ForceTarget, target.span,
                           fmt::format("`{}` is {}", context_.sources.text(target.span), is));
  }
  return {};
}

Evaluator::Target Evaluator::numbered_target(const ast::Expression& target, const Frame* frame) {
  const std::optional<long> number = whole_number(target, frame, "the number of a particle");
  if (!number) {
    return {};
  }
  const auto found = context_.symbols.numbered_particles.find(*number);
  if (found == context_.symbols.numbered_particles.end() || frame->scope->module != nullptr) {
    if (context_.symbols.numbers_complete) {
      context_.report.report(Finding::ForceTarget, target.span, fmt::format("there is no particle {}", *number));
    }
    return {};
  }
  return {&context_.symbols.particles[found->second.position]};
}

Variable* Evaluator::moving(const ast::Motion& motion, const Frame* frame) {
  const auto& reference = std::get<Reference>(motion.target.node);
  const Base found = base(reference, frame);
  if (found.value.is_nothing() && found.definition == nullptr && found.particle == nullptr && found.part == nullptr) {
    return nullptr;
  }
  const bool is_equation = motion.kind == ast::MotionKind::Equation;
  const bool is_variable = found.variable != nullptr && found.steps == reference.steps.size();
  const SymbolKind wanted = is_equation ? SymbolKind::State : SymbolKind::Coordinate;
  if (!is_variable || kind_of(found.variable->syntax->kind) != wanted) {
    const std::string_view is = is_variable ? describe(kind_of(found.variable->syntax->kind)) : "none";
    context_.report.report(Finding::MotionTarget, motion.target.span, is_equation ? "equation" : "kinematics",
                           describe(wanted), fmt::format("`{}` is {}", context_.sources.text(motion.target.span), is));
    return nullptr;
  }
  return &context_.symbols.variables[static_cast<std::size_t>(found.variable - context_.symbols.variables.data())];
}

}  // namespace mbcc::model
