#include <fmt/format.h>

#include "model/names.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {

void SystemBuilder::add(const ast::Output& output, const Instance& instance) {
  const ast::Declarator& declarator = output.name;
  const Value value = evaluator_.evaluate(output.value, instance.frame);
  const std::optional<Indices> indices = evaluator_.indices(declarator.indices, instance.frame);
  if (is_in_loop(instance.frame) && declarator.indices.empty()) {
    context_.report.report(Finding::NeedsIndex, declarator.span, declarator.name, declarator.name,
                           instance.frame->index);
    return;
  }
  if (!indices) {
    return;
  }
  const std::string name = instance.frame->scope->path_of(element_name(declarator.name, *indices));
  for (std::size_t axis = 0; axis < value.size(); ++axis) {
    add_column(value.is_vector() ? fmt::format("{}.{}", name, axis_names[axis]) : name, value[axis], output);
  }
}

void SystemBuilder::add_column(const std::string& name, const Scalar& value, const ast::Output& output) {
  const Span span = output.name.span;
  if (motion_columns_.count(name) != 0) {
    context_.report.report(Finding::ReservedName, span, name, "a column of every result");
    return;
  }
  if (const auto [column, is_new] = output_columns_.try_emplace(name, span); !is_new) {
    context_.report.report(Finding::AlreadyDeclared, span, name).note(column->second, "first declared here");
    return;
  }
  system_.outputs.push_back({name, context_.arena.node(value, output.value.span), output.value.span});
}

}  // namespace mbcc::model
