// Names in expressions.

#include <fmt/format.h>

#include <numbers>

#include "diagnostics/spelling.hpp"
#include "model/evaluator.hpp"
#include "model/names.hpp"

namespace mbcc::model {

Value Evaluator::visit(const Reference& reference, Span span, const Frame* frame) {
  const Base start = base(reference, frame);
  const std::vector<ast::Step>& steps = reference.steps;
  if (start.particle == nullptr && start.part == nullptr && start.definition == nullptr && start.value.is_nothing()) {
    return {};
  }
  if (start.part != nullptr) {
    report_not_a_value(*start.part, span);
    return {};
  }
  if (start.particle != nullptr && steps.size() == start.steps) {
    context_.report.report(Finding::NotAValue, span, start.particle->name, "a particle",
                           fmt::format(": write `{}.position` or the like", start.particle->name));
    return {};
  }
  const bool is_point = start.definition != nullptr && is_position(start.definition->kind);
  Value value = start.definition != nullptr ? value_of(*start.definition, steps[start.steps - 1].span) : start.value;
  std::string path = start.definition != nullptr ? start.definition->name : steps.front().name;
  for (std::size_t i = start.steps; i < steps.size(); ++i) {
    const ast::Step& step = steps[i];
    if (!step.indices.empty()) {
      context_.report.report(Finding::IndexCount, step.span, step.name, indices_taken(0), step.indices.size());
      return {};
    }
    const bool is_member = i == start.steps && (start.particle != nullptr || is_point);
    value = !is_member                  ? component(value, path, step)
            : start.particle != nullptr ? member(*start.particle, step, span)
                                        : member(*start.definition, step, span);
    path += "." + step.name;
  }
  return value;
}

Evaluator::Base Evaluator::base(const Reference& reference, const Frame* frame) {
  Base base = first(reference.steps.front(), frame);
  for (std::size_t i = 1; base.part != nullptr && i < reference.steps.size(); ++i) {
    const ast::Step& step = reference.steps[i];
    const Symbol* symbol = base.part->find(step.name);
    if (symbol == nullptr) {
      report_unknown_element(*base.part, step);
      return {};
    }
    base = element(*symbol, step, frame);
    base.steps = i + 1;
  }
  return base;
}

Evaluator::Base Evaluator::first(const ast::Step& step, const Frame* frame) {
  Base base;
  if (step.indices.empty()) {
    if (const Frame* index = find_index(frame, step.name)) {
      base.value = static_cast<double>(index->value);
      return base;
    }
    base.definition = find_local(frame, step.name);
  }
  if (base.definition == nullptr) {
    if (const Symbol* symbol = frame->scope->find(step.name)) {
      return element(*symbol, step, frame);
    }
    base.value = built_in(step, frame);
  }
  return base;
}

Evaluator::Base Evaluator::element(const Symbol& symbol, const ast::Step& step, const Frame* frame) {
  const bool moves = symbol.kind == SymbolKind::Particle || is_variable(symbol.kind) ||
                     symbol.kind == SymbolKind::Constraint || symbol.kind == SymbolKind::Part;
  if (moves && refuse_unless_structural(step.name, describe(symbol.kind), step.span)) {
    return {};
  }
  if (symbol.kind == SymbolKind::Constraint) {
    context_.report.report(Finding::NotAValue, step.span, step.name, "a constraint", "");
    return {};
  }
  if (step.indices.size() != symbol.index_count) {
    context_.report.report(Finding::IndexCount, step.span, step.name, indices_taken(symbol.index_count),
                           step.indices.empty() ? "none" : fmt::to_string(step.indices.size()));
    return {};
  }
  const std::optional<Indices> at = indices(step.indices, frame);
  if (!at) {
    return {};
  }
  const auto found = symbol.elements.find(*at);
  if (found == symbol.elements.end()) {
    // The dimension is found before anything but constants is entered.
    if (symbol.kind != SymbolKind::Constant && refuse_unless_structural(step.name, describe(symbol.kind), step.span)) {
      return {};
    }
    report_not_declared(symbol, step, *at, frame);
    return {};
  }
  Base base;
  if (symbol.kind == SymbolKind::Part) {
    base.part = &context_.symbols.scopes[found->second.position];
  } else if (symbol.kind == SymbolKind::Particle) {
    base.particle = &context_.symbols.particles[found->second.position];
  } else if (is_variable(symbol.kind)) {
    base.variable = &context_.symbols.variables[found->second.position];
    base.value = base.variable->is_speed()
                     ? context_.arena.leaf(ExpressionKind::Speed, base.variable->speed, step.span)
                     : context_.arena.leaf(ExpressionKind::Coordinate, base.variable->coordinate, step.span);
  } else {
    base.definition = &context_.symbols.definitions[found->second.position];
  }
  return base;
}

Value Evaluator::built_in(const ast::Step& step, const Frame* frame) {
  if (step.indices.empty()) {
    if (step.name == "pi") {
      return std::numbers::pi;
    }
    if (step.name == "t") {
      const bool refused = refuse_unless_structural(step.name, "the time", step.span);
      return refused ? Value() : Value(context_.arena.leaf(ExpressionKind::Time, 0, step.span));
    }
    if (const std::optional<NumberedVariable> variable = find_numbered_variable(step.name)) {
      return numbered(*variable, step, frame);
    }
  }
  report_unknown(step, frame);
  return {};
}

Value Evaluator::numbered(const NumberedVariable& variable, const ast::Step& step, const Frame* frame) {
  const std::string_view is = variable.member.is_velocity ? "a speed" : "a coordinate";
  if (refuse_unless_structural(step.name, is, step.span)) {
    return {};
  }
  const auto found = context_.symbols.numbered_particles.find(variable.particle);
  if (frame->scope->module != nullptr || found == context_.symbols.numbered_particles.end() ||
      static_cast<int>(*variable.member.axis) >= context_.dimension) {
    report_unknown(step, frame);
    return {};
  }
  return motion(context_.symbols.particles[found->second.position], variable.member, step.span);
}

std::optional<Member> Evaluator::member_of(const std::string& owner, const ast::Step& step) {
  const std::optional<Member> member = find_member(step.name);
  if (!member || (member->axis && static_cast<int>(*member->axis) >= context_.dimension)) {
    const std::string more = member ? fmt::format(" in dimension {}", context_.dimension)
                                    : suggestion(step.name, member_names(context_.dimension));
    context_.report.report(Finding::UnknownMember, step.span, owner, step.name, more);
    return std::nullopt;
  }
  return member;
}

Value Evaluator::member(const Particle& particle, const ast::Step& step, Span span) {
  const std::optional<Member> member = member_of(particle.name, step);
  return member ? motion(particle, *member, span) : Value();
}

Value Evaluator::member(Definition& point, const ast::Step& step, Span span) {
  const std::optional<Member> member = member_of(point.name, step);
  const Value position = value_of(point, span);
  if (!member || position.is_nothing()) {
    return {};
  }
  const Value whole = member->is_velocity ? algebra_.rate(position, span) : position;
  return member->axis ? Value(whole[*member->axis]) : whole;
}

Value Evaluator::component(const Value& value, const std::string& name, const ast::Step& step) {
  if (value.is_nothing()) {
    return {};
  }
  const std::optional<std::size_t> axis = find_axis(step.name);
  if (value.is_scalar() || !axis || *axis >= value.size()) {
    context_.report.report(Finding::UnknownMember, step.span, name, step.name,
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
