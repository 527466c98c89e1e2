// What a force acts on.

#include <fmt/format.h>

#include "model/evaluator.hpp"

namespace mbcc::model {

const Particle* Evaluator::particle(const ast::Expression& target, const Frame* frame) {
  const auto* reference = std::get_if<Reference>(&target.node);
  const ast::Part* part = reference != nullptr && reference->parts.size() == 1 ? &reference->parts[0] : nullptr;
  const bool is_index = part != nullptr && part->indices.empty() && find_index(frame, part->name) != nullptr;
  if (is_index || std::holds_alternative<ast::Number>(target.node)) {
    return numbered_target(target, frame);
  }
  if (part == nullptr) {
    context_.report.report(Finding::ForceTarget, target.span,
                           fmt::format("`{}` is none", context_.sources.text(target.span)));
    return nullptr;
  }
  const Symbol* symbol = context_.symbols.find(part->name);
  const bool is_local = find_local(frame, part->name) != nullptr;
  if (is_local || (symbol != nullptr && symbol->kind != SymbolKind::Particle)) {
    const std::string_view is = describe(is_local ? SymbolKind::Let : symbol->kind);
    context_.report.report(Finding::ForceTarget, target.span, fmt::format("`{}` is {}", part->name, is));
    return nullptr;
  }
  if (symbol == nullptr) {
    report_unknown(*part, frame);
    return nullptr;
  }
  return element(*symbol, *part, frame).particle;
}

const Particle* Evaluator::numbered_target(const ast::Expression& target, const Frame* frame) {
  const std::optional<long> number = whole_number(target, frame, "the number of a particle");
  if (!number) {
    return nullptr;
  }
  const auto found = context_.symbols.numbered_particles.find(*number);
  if (found == context_.symbols.numbered_particles.end()) {
    if (context_.symbols.numbers_complete) {
      context_.report.report(Finding::ForceTarget, target.span, fmt::format("there is no particle {}", *number));
    }
    return nullptr;
  }
  return &context_.symbols.particles[found->second.position];
}

}  // namespace mbcc::model
