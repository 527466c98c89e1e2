#include "graph/print.hpp"

#include <fmt/format.h>

#include <optional>
#include <unordered_map>

#include "graph/evaluate.hpp"

namespace mbcc::graph {

namespace {

/// How tightly text binds, loosest first.
enum class Binding { Comparison, Sum, Product, Sign, Power, Primary };

struct Text {
  std::string text;
  Binding binding;
};

std::string bound(const Text& text, Binding at_least) {
  return text.binding < at_least ? fmt::format("({})", text.text) : text.text;
}

Binding tighter(Binding binding) { return static_cast<Binding>(static_cast<int>(binding) + 1); }

std::optional<Binding> infix_binding(Operator op) {
  switch (op) {
    case Operator::Add:
    case Operator::Subtract:
      return Binding::Sum;
    case Operator::Multiply:
    case Operator::Divide:
      return Binding::Product;
    case Operator::Power:
      return Binding::Power;
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Equal:
      return Binding::Comparison;
    default:
      return std::nullopt;
  }
}

Text compose(const Node& node, const std::vector<Text>& operands) {
  const std::string_view spelling = row(node.op).spelling;
  if (const auto binding = infix_binding(node.op)) {
    const std::string_view space = *binding == Binding::Power ? "" : " ";
    return {fmt::format("{}{}{}{}{}", bound(operands[0], *binding), space, spelling, space,
                        bound(operands[1], tighter(*binding))),
            *binding};
  }
  if (node.op == Operator::Negate) {
    return {"-" + bound(operands[0], Binding::Product), Binding::Sum};
  }
  std::string arguments;
  for (const Text& operand : operands) {
    arguments += (arguments.empty() ? "" : ", ") + operand.text;
  }
  return {fmt::format("{}({})", spelling, arguments), Binding::Primary};
}

}  // namespace

std::string print(std::span<const std::pair<std::string, Expr>> labelled, const LeafName& leaf_name) {
  if (labelled.empty()) {
    return {};
  }
  const Graph& graph = labelled.front().second.graph();
  std::vector<Expr> roots;
  for (const auto& [label, expression] : labelled) {
    roots.push_back(expression);
  }
  const std::vector<NodeId> order = reachable(graph, roots);
  std::unordered_map<NodeId, int> uses;
  for (const NodeId id : order) {
    for (const NodeId operand : graph[id].used_operands()) {
      ++uses[operand];
    }
  }
  std::string lines;
  std::unordered_map<NodeId, Text> texts;
  int shared = 0;
  for (const NodeId id : order) {
    const Node& node = graph[id];
    if (node.kind == Kind::Constant) {
      texts[id] = {fmt::format("{}", node.value), node.value < 0 ? Binding::Sum : Binding::Primary};
      continue;
    }
    if (node.kind != Kind::Apply) {
      texts[id] = {leaf_name(node), Binding::Primary};
      continue;
    }
    std::vector<Text> operands;
    for (const NodeId operand : node.used_operands()) {
      operands.push_back(texts.at(operand));
    }
    texts[id] = compose(node, operands);
    if (uses[id] > 1) {
      const std::string name = fmt::format("#{}", ++shared);
      lines += fmt::format("{} = {}\n", name, texts[id].text);
      texts[id] = {name, Binding::Primary};
    }
  }
  for (const auto& [label, expression] : labelled) {
    lines += fmt::format("{} = {}\n", label, texts.at(expression.id()).text);
  }
  return lines;
}

}  // namespace mbcc::graph
