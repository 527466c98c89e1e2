#pragma once
// Note [lowering]: the last rewriting before code. The lowered graph is a graph of its own, whose nodes are exactly
// the operations that will be done:
//   * x^n with an integer |n| <= 32 becomes multiplications by repeated squaring (and one division where n < 0);
//   * three or more divisions by one denominator, and divisions whose denominator is known earlier (at a lower level)
//     than the numerator, become multiplications by its reciprocal, which is computed once and at its own level. Two
//     divisions stay: they overlap, and the reciprocal would lengthen the chain of pivots (measured: 10 % of a chain).

#include <span>
#include <unordered_map>
#include <unordered_set>

#include "graph/graph.hpp"

namespace mbcc::program {

/// The lowered counterparts of `roots` and of all that they need.
class Lowering {
 public:
  Lowering(std::span<const graph::Expr> roots, graph::Graph& lowered);

  /// Whether `expression` is one of the roots or needed by them; only then does it have a counterpart.
  bool contains(graph::Expr expression) const { return images_.contains(expression.id()); }
  graph::NodeId operator()(graph::Expr expression) const { return images_.at(expression.id()).id(); }

 private:
  graph::Expr lower(const graph::Graph& graph, const graph::Node& node);
  graph::Expr make(graph::Operator op, graph::Expr a, graph::Expr b);
  graph::Expr reciprocal(graph::Expr x);
  graph::Expr integer_power(graph::Expr base, int exponent);

  graph::Graph& lowered_;
  std::unordered_set<graph::NodeId> shared_denominators_;
  std::unordered_map<graph::NodeId, graph::Expr> images_;
};

}  // namespace mbcc::program
