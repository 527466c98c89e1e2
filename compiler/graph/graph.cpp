#include "graph/graph.hpp"

#include <algorithm>
#include <bit>

#include "diagnostics/assert.hpp"

namespace mbcc::graph {

std::size_t Graph::Hash::operator()(const Node& node) const {
  std::uint64_t hash = (static_cast<std::uint64_t>(node.kind) << 8) | static_cast<std::uint64_t>(node.op);
  const auto mix = [&hash](std::uint64_t word) { hash = (std::rotl(hash, 23) ^ word) * 0x9E3779B97F4A7C15u; };
  mix(node.index);
  mix(std::bit_cast<std::uint64_t>(node.value));
  for (const NodeId operand : node.operands) {
    mix(operand);
  }
  return hash ^ (hash >> 32);
}

/// Constants are compared by their bits: 0 and -0 are two, and a NaN is itself.
bool Graph::Same::operator()(const Node& a, const Node& b) const {
  return a.kind == b.kind && a.op == b.op && a.index == b.index && a.operands == b.operands &&
         std::bit_cast<std::uint64_t>(a.value) == std::bit_cast<std::uint64_t>(b.value);
}

Expr Graph::intern(const Node& node) {
  const auto [found, is_new] = ids_.try_emplace(node, static_cast<NodeId>(nodes_.size()));
  if (is_new) {
    nodes_.push_back(node);
  }
  return {*this, found->second};
}

Expr Graph::constant(double value) {
  Node node;
  node.value = value;
  return intern(node);
}

Expr Graph::leaf(Kind kind, std::uint32_t index) {
  Node node;
  node.kind = kind;
  node.index = index;
  node.level = kind == Kind::Parameter      ? Level::Parameter
               : kind == Kind::Time         ? Level::Time
               : kind <= Kind::Acceleration ? Level::State
                                            : Level::Order;
  return intern(node);
}

Node Graph::application(Operator op, std::span<const Expr> operands) const {
  MBCC_ASSERT(operands.size() == static_cast<std::size_t>(arity(op)));
  Node node;
  node.kind = Kind::Apply;
  node.op = op;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    MBCC_ASSERT(&operands[i].graph() == this);
    node.operands[i] = operands[i].id();
    node.level = std::max(node.level, operands[i].level());
  }
  return node;
}

Expr Graph::intern(Operator op, std::span<const Expr> operands) { return intern(application(op, operands)); }

bool Graph::contains(Operator op, std::span<const Expr> operands) const {
  return ids_.contains(application(op, operands));
}

}  // namespace mbcc::graph
