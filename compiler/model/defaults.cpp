#include <cmath>
#include <set>
#include <unordered_map>

#include "diagnostics/assert.hpp"
#include "graph/evaluate.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {
namespace {

/// The nodes that `root` needs, operands first.
std::set<ExpressionId> needed_by(const Arena& arena, ExpressionId root) {
  std::set<ExpressionId> needed;
  std::vector<ExpressionId> open = {root};
  while (!open.empty()) {
    const ExpressionId id = open.back();
    open.pop_back();
    if (needed.insert(id).second) {
      const Expression& expression = arena.expressions()[index(id)];
      open.insert(open.end(), expression.operands.begin(),
                  expression.operands.begin() + static_cast<std::ptrdiff_t>(operand_count(expression)));
    }
  }
  return needed;
}

}  // namespace

std::optional<double> value_at_defaults(const Arena& arena, const std::vector<Parameter>& parameters, ExpressionId id) {
  std::unordered_map<std::uint32_t, double> values;
  for (const ExpressionId needed : needed_by(arena, id)) {
    const Expression& expression = arena.expressions()[index(needed)];
    double& value = values[index(needed)];
    if (expression.kind == ExpressionKind::Number) {
      value = expression.number;
    } else if (expression.kind == ExpressionKind::Parameter) {
      value = parameters[expression.index].value;
      if (std::isnan(value)) {
        return std::nullopt;
      }
    } else {
      MBCC_ASSERT(expression.kind == ExpressionKind::Apply);
      std::array<const double*, 3> operands{};
      for (std::size_t i = 0; i < operand_count(expression); ++i) {
        operands[i] = &values.at(index(expression.operands[i]));
      }
      value = graph::perform<double>(expression.op, operands);
    }
  }
  return values.at(index(id));
}

}  // namespace mbcc::model
