#include "graph/print.hpp"

#include <fmt/format.h>

#include <unordered_map>

#include "graph/evaluate.hpp"

namespace mbcc::graph {

namespace {

struct Text {
  std::string text;
  Precedence binding;
};

std::string bound(const Text& text, Precedence at_least) {
  return text.binding < at_least ? fmt::format("({})", text.text) : text.text;
}

Text compose(const Node& node, const std::vector<Text>& operands) {
  const std::string_view spelling = row(node.op).spelling;
  const Precedence own = precedence(node.op);
  if (own == Precedence::Sign) {
    return {"-" + bound(operands[0], Precedence::Product), Precedence::Sum};
  }
  if (own != Precedence::Operand) {
    const std::string_view space = own == Precedence::Power ? "" : " ";
    return {
        fmt::format("{}{}{}{}{}", bound(operands[0], own), space, spelling, space, bound(operands[1], tighter(own))),
        own};
  }
  std::string arguments;
  for (const Text& operand : operands) {
    arguments += (arguments.empty() ? "" : ", ") + operand.text;
  }
  return {fmt::format("{}({})", spelling, arguments), Precedence::Operand};
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
      texts[id] = {fmt::format("{}", node.value), node.value < 0 ? Precedence::Sum : Precedence::Operand};
      continue;
    }
    if (node.kind != Kind::Apply) {
      texts[id] = {leaf_name(node), Precedence::Operand};
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
      texts[id] = {name, Precedence::Operand};
    }
  }
  for (const auto& [label, expression] : labelled) {
    lines += fmt::format("{} = {}\n", label, texts.at(expression.id()).text);
  }
  return lines;
}

}  // namespace mbcc::graph
