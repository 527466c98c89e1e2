#pragma once
// One walk over the graph, in any algebra T.

#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "graph/graph.hpp"
#include "graph/in_order.hpp"
#include "graph/numbers.hpp"

namespace mbcc::graph {

/// `op` applied to `operands` in the algebra T.
template <class T>
T perform(Operator op, const std::array<const T*, 3>& operands) {
  MBCC_USING_ELEMENTARY_FUNCTIONS;
  switch (op) {
#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  case Operator::name:                                                      \
    return function(*operands[0]);
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  case Operator::name:                                                               \
    return function(*operands[0], *operands[1]);
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  case Operator::name:                                                                        \
    return function(*operands[0], *operands[1], *operands[2]);
#include "graph/operators.def"
  }
  return *operands[0];
}

/// d a^b / da: Note [powers of zero].
template <class T>
T slope_of_power(const T& a, const T& b) {
  MBCC_USING_ELEMENTARY_FUNCTIONS;
  const T is_constant = equal(b, number(b, 0));
  return select(is_constant, number(b, 0), b * pow(a, b - number(b, 1)));
}

/// Partial derivative of `op`, of value `r` at the operands, with respect to operand `which`.
template <class T>
T slope(Operator op, std::size_t which, const T& r, const std::array<const T*, 3>& operands) {
  MBCC_USING_ELEMENTARY_FUNCTIONS;
  const T& a = *operands[0];
  [[maybe_unused]] const T& b = operands[1] != nullptr ? *operands[1] : a;
  switch (op) {
#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  case Operator::name:                                                      \
    return slope_a;
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  case Operator::name:                                                               \
    return which == 0 ? (slope_a) : (slope_b);
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  case Operator::name:                                                                        \
    return which == 0 ? (slope_a) : which == 1 ? (slope_b) : (slope_c);
#include "graph/operators.def"
  }
  return r;
}

/// The nodes that `roots` need, operands before users.
inline std::vector<NodeId> reachable(const Graph& graph, std::span<const Expr> roots) {
  std::vector<NodeId> open;
  std::vector<NodeId> found;
  std::unordered_map<NodeId, bool> seen;
  for (const Expr root : roots) {
    open.push_back(root.id());
  }
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    if (!seen.try_emplace(id, true).second) {
      continue;
    }
    found.push_back(id);
    for (const NodeId operand : graph[id].used_operands()) {
      open.push_back(operand);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Values of `roots`; `leaf(node)` gives the value of a node that is no application.
template <class T, class Leaf>
std::vector<T> evaluate(const Graph& graph, std::span<const Expr> roots, const Leaf& leaf) {
  const std::vector<NodeId> order = reachable(graph, roots);
  std::unordered_map<NodeId, T> values;
  values.reserve(order.size());
  for (const NodeId id : order) {
    const Node node = graph[id];  // a copy: in the algebra of expressions the graph grows during the walk
    if (node.kind != Kind::Apply) {
      values.emplace(id, leaf(node));
      continue;
    }
    std::array<const T*, 3> operands{};
    for (std::size_t i = 0; i < node.used_operands().size(); ++i) {
      operands[i] = &values.at(node.operands[i]);
    }
    values.emplace(id, perform(node.op, operands));
  }
  std::vector<T> results;
  results.reserve(roots.size());
  for (const Expr root : roots) {
    results.push_back(values.at(root.id()));
  }
  return results;
}

}  // namespace mbcc::graph
