#include "model/system_builder.hpp"

#include <limits>

namespace mbcc::model {

void SystemBuilder::add_parameters() {
  for (Definition& definition : context_.symbols.definitions) {
    if (definition.kind == SymbolKind::Parameter) {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      const Value value = evaluator_.evaluate(definition);
      system_.parameters.push_back(
          {definition.name, value.is_nothing() ? unknown : value[0].number, definition.declarator->span});
    }
  }
}

void SystemBuilder::add(const Instance& instance) {
  const Reporter::Within within(context_.report, instance.frame->scope->trace);
  std::visit([&](const auto& node) { add(node, instance); }, instance.statement->node);
}

void SystemBuilder::add(const ast::System& title, const Instance& instance) {
  if (instance.statement->span.file == 0) {
    system_.name = title.name;
  }
}

}  // namespace mbcc::model
