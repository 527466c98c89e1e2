// Names in expressions.

#include <fmt/format.h>

#include <numbers>

#include "diagnostics/spelling.hpp"
#include "model/evaluator.hpp"
#include "model/names.hpp"

namespace mbcc::model {

Value Evaluator::visit(const Reference& reference, Span span, const Frame* frame) {
  const Base start = base(reference, frame);
  Value value = start.value;
  std::string path = reference.parts.front().name;
  for (std::size_t i = 1; i < reference.parts.size(); ++i) {
    const ast::Part& part = reference.parts[i];
    if (!part.indices.empty()) {
      context_.report.report(Finding::IndexCount, part.span, part.name, indices_taken(0), part.indices.size());
      return {};
    }
    const bool of_particle = i == 1 && start.particle != nullptr;
    value = of_particle ? member(*start.particle, part, span) : component(value, path, part);
    path += "." + part.name;
  }
  if (start.particle != nullptr && reference.parts.size() == 1) {
    context_.report.report(Finding::NotAValue, span, start.particle->name, "a particle",
                           fmt::format(": write `{}.position` or the like", start.particle->name));
    return {};
  }
  return value;
}

Evaluator::Base Evaluator::base(const Reference& reference, const Frame* frame) {
  const ast::Part& part = reference.parts.front();
  if (part.indices.empty()) {
    if (const Frame* index = find_index(frame, part.name)) {
      return {static_cast<double>(index->value), nullptr};
    }
    if (Definition* local = find_local(frame, part.name)) {
      return {value_of(*local, part.span), nullptr};
    }
  }
  if (const Symbol* symbol = context_.symbols.find(part.name)) {
    return element(*symbol, part, frame);
  }
  return {built_in(part, frame), nullptr};
}

Evaluator::Base Evaluator::element(const Symbol& symbol, const ast::Part& part, const Frame* frame) {
  const bool is_definition = symbol.kind != SymbolKind::Particle && symbol.kind != SymbolKind::Constraint;
  if (!is_definition && refuse_unless_structural(part.name, describe(symbol.kind), part.span)) {
    return {};
  }
  if (symbol.kind == SymbolKind::Constraint) {
    context_.report.report(Finding::NotAValue, part.span, part.name, "a constraint", "");
    return {};
  }
  if (part.indices.size() != symbol.index_count) {
    context_.report.report(Finding::IndexCount, part.span, part.name, indices_taken(symbol.index_count),
                           part.indices.empty() ? "none" : fmt::to_string(part.indices.size()));
    return {};
  }
  const std::optional<Indices> at = indices(part.indices, frame);
  if (!at) {
    return {};
  }
  const auto found = symbol.elements.find(*at);
  if (found == symbol.elements.end()) {
    // The dimension is found before anything but constants is entered.
    if (symbol.kind != SymbolKind::Constant && refuse_unless_structural(part.name, describe(symbol.kind), part.span)) {
      return {};
    }
    report_not_declared(symbol, part, *at, frame);
    return {};
  }
  if (is_definition) {
    return {value_of(context_.symbols.definitions[found->second.position], part.span), nullptr};
  }
  return {Value(), &context_.symbols.particles[found->second.position]};
}

Value Evaluator::built_in(const ast::Part& part, const Frame* frame) {
  if (part.indices.empty()) {
    if (part.name == "pi") {
      return std::numbers::pi;
    }
    if (part.name == "t") {
      const bool refused = refuse_unless_structural(part.name, "the time", part.span);
      return refused ? Value() : Value(context_.arena.leaf(ExpressionKind::Time, 0, part.span));
    }
    if (const std::optional<NumberedVariable> variable = find_numbered_variable(part.name)) {
      return numbered(*variable, part, frame);
    }
  }
  report_unknown(part, frame);
  return {};
}

Value Evaluator::numbered(const NumberedVariable& variable, const ast::Part& part, const Frame* frame) {
  const std::string_view is = variable.member.is_velocity ? "a speed" : "a coordinate";
  if (refuse_unless_structural(part.name, is, part.span)) {
    return {};
  }
  const auto found = context_.symbols.numbered_particles.find(variable.particle);
  if (found == context_.symbols.numbered_particles.end() ||
      static_cast<int>(*variable.member.axis) >= context_.dimension) {
    report_unknown(part, frame);
    return {};
  }
  return motion(context_.symbols.particles[found->second.position], variable.member, part.span);
}

Value Evaluator::member(const Particle& particle, const ast::Part& part, Span span) {
  const std::optional<Member> member = find_member(part.name);
  if (!member || (member->axis && static_cast<int>(*member->axis) >= context_.dimension)) {
    const std::string more = member ? fmt::format(" in dimension {}", context_.dimension)
                                    : suggestion(part.name, member_names(context_.dimension));
    context_.report.report(Finding::UnknownMember, part.span, particle.name, part.name, more);
    return {};
  }
  return motion(particle, *member, span);
}

Value Evaluator::component(const Value& value, const std::string& name, const ast::Part& part) {
  if (value.is_nothing()) {
    return {};
  }
  const std::optional<std::size_t> axis = find_axis(part.name);
  if (value.is_scalar() || !axis || *axis >= value.size()) {
    context_.report.report(Finding::UnknownMember, part.span, name, part.name,
                           fmt::format(": it is {}", describe(value)));
    return {};
  }
  return value[*axis];
}

Value Evaluator::motion(const Particle& particle, const Member& member, Span span) {
  const auto dimension = static_cast<std::size_t>(context_.dimension);
  const ExpressionKind kind = member.is_velocity ? ExpressionKind::Speed : ExpressionKind::Coordinate;
  Value value;
  for (std::size_t axis = 0; axis < dimension; ++axis) {
    if (!member.axis || axis == *member.axis) {
      value.append(context_.arena.leaf(kind, context_.motion_index(particle, axis), span));
    }
  }
  return value;
}

bool Evaluator::refuse_unless_structural(std::string_view name, std::string_view is, Span span) {
  if (!structural_.empty()) {
    const bool is_default = structural_ == default_of_parameter;
    const std::string_view advice = is_default ? ": a derived value is a `let`"
                                    : is == describe(SymbolKind::Let) || is == describe(SymbolKind::Parameter)
                                        ? ": declare it as a `constant`"
                                        : "";
    context_.report.report(Finding::NotStructural, span, structural_, name, is, advice);
  }
  return !structural_.empty();
}

}  // namespace mbcc::model
