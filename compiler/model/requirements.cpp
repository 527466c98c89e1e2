// What statements ask of the values that they are given.

#include <fmt/format.h>

#include <algorithm>

#include "diagnostics/spelling.hpp"
#include "model/names.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {

Value Algebra::expect_vector(const Operand& operand, std::string_view what) {
  const Value& value = operand.value;
  const auto dimension = static_cast<std::size_t>(context_.dimension);
  if (value.is_nothing() || value.size() == dimension) {
    return value;
  }
  Value zeros;
  for (std::size_t i = 0; i < dimension; ++i) {
    zeros.append({});
  }
  if (value.is_zero()) {
    return zeros;
  }
  context_.report.report(Finding::VectorExpected, operand.span, what, describe(zeros), describe(value));
  return {};
}

bool Algebra::expect_independent(const Operand& operand, Quantities unwanted, std::string_view what) {
  for (const Scalar& component : operand.value) {
    if (!overlap(context_.arena.quantities(component), unwanted)) {
      continue;
    }
    const Expression& source = context_.arena.source_of(component, unwanted);
    const Span span = covers(operand.span, source.span) ? source.span : operand.span;
    const bool is_acceleration = unwanted == Quantities::Acceleration;
    const std::string_view text = context_.sources.text(source.span);
    Diagnostic& finding = is_acceleration ? context_.report.report(Finding::AccelerationUsed, span, text)
                                          : context_.report.report(Finding::CannotDependOn, span, what, text);
    if (span != source.span) {
      finding.note(source.span, "it is used here");
    }
    return false;
  }
  return true;
}

SystemBuilder::Fields SystemBuilder::fields_of(std::string_view block, const std::vector<ast::Field>& fields,
                                               const std::vector<std::string_view>& known) {
  Fields found;
  for (const ast::Field& field : fields) {
    if (std::find(known.begin(), known.end(), field.name) == known.end()) {
      context_.report.report(Finding::UnknownField, field.name_span, block, field.name, suggestion(field.name, known));
    } else if (const auto [first, is_new] = found.try_emplace(field.name, &field); !is_new) {
      context_.report.report(Finding::GivenTwice, field.name_span, field.name)
          .note(first->second->name_span, "first given here");
    }
  }
  return found;
}

Span component_span(const ast::Expression& expression, std::size_t axis) {
  const auto* vector = std::get_if<ast::Vector>(&expression.node);
  return vector != nullptr ? vector->components[axis].span : expression.span;
}

}  // namespace mbcc::model
