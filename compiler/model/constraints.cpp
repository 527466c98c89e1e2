#include <fmt/format.h>

#include <algorithm>

#include "model/names.hpp"
#include "model/system_builder.hpp"
#include "source/text.hpp"

namespace mbcc::model {
namespace {

std::optional<Template> template_of(const Instance& instance) {
  if (!is_in_loop(instance.frame) && !instance.frame->scope->is_part()) {
    return std::nullopt;
  }
  Template made_by{instance.statement->span, {}};
  for (const Frame* frame = instance.frame; frame != nullptr; frame = frame->scope->made_in) {
    for (; is_in_loop(frame); frame = frame->outer) {
      made_by.indices.push_back(frame->value);
    }
  }
  std::reverse(made_by.indices.begin(), made_by.indices.end());
  return made_by;
}

}  // namespace

void SystemBuilder::add(const ast::Constraint& constraint, const Instance& instance) {
  Scope& scope = *instance.frame->scope;
  ++scope.constraints_so_far;
  std::string name = fmt::format("constraint_{}", scope.constraints_so_far);
  if (constraint.label) {
    const std::optional<Indices> indices = evaluator_.indices(constraint.label->indices, instance.frame);
    name = element_name(constraint.label->name, indices.value_or(Indices{}));
  }
  name = scope.path_of(name);
  const Span span = join(constraint.sides.front().span, constraint.sides.back().span);
  const Value rows = equation(constraint, span, instance.frame);
  for (std::size_t axis = 0; axis < rows.size(); ++axis) {
    const std::string row = rows.is_vector() ? fmt::format("{}.{}", name, axis_names[axis]) : name;
    if (can_hold(row, {rows[axis], span})) {
      const bool holonomic = !overlap(context_.arena.quantities(rows[axis]), Quantities::Speed);
      system_.constraints.push_back(
          {row, *rows[axis].node, holonomic, span, one_line(context_.sources.text(span)), template_of(instance)});
    }
  }
}

/// Left minus right side.
Value SystemBuilder::equation(const ast::Constraint& constraint, Span span, const Frame* frame) {
  std::vector<Operand> sides;
  for (const ast::Expression& side : constraint.sides) {
    sides.push_back({evaluator_.evaluate(side, frame), side.span});
  }
  if (sides.size() > 2) {
    context_.report.report(Finding::SeveralEquals, span, sides.size());
    return {};
  }
  if (sides.size() == 1) {
    return sides[0].value;
  }
  const Value& left = sides[0].value;
  const Value& right = sides[1].value;
  const bool fits = left.size() == right.size() || left.is_zero() || right.is_zero();
  if (!left.is_nothing() && !right.is_nothing() && !fits) {
    context_.report.report(Finding::SidesDiffer, span, describe(left), describe(right));
    return {};
  }
  return evaluator_.algebra().subtract(sides[0], sides[1], span, span);
}

bool SystemBuilder::can_hold(const std::string& name, const Operand& row) {
  const Scalar& value = row.value[0];
  if (value.is_number()) {
    if (value.is_zero()) {
      context_.report.report(Finding::IdenticallyTrue, row.span, name);
    } else {
      context_.report.report(Finding::NeverTrue, row.span, name, value.number);
    }
    return false;
  }
  if (!expect_independent(row, Quantities::Acceleration, "a constraint")) {
    return false;
  }
  if (!overlap(context_.arena.quantities(value), Quantities::Coordinate | Quantities::Speed)) {
    context_.report.report(Finding::NoMotionInConstraint, row.span, name);
    return false;
  }
  return true;
}

}  // namespace mbcc::model
