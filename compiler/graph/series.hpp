#pragma once
// Taylor coefficients of expressions as numbers, order by order: Note [recurrences] (recurrence.hpp) over double. The
// oracle for emitted series, and what the recurrences themselves are tested through.

#include <functional>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "graph/recurrence.hpp"

namespace mbcc::graph {

/// The series of some roots, along a motion whose own coefficients may become known only from those of the roots.
class Series {
 public:
  /// A value or a coefficient of a leaf.
  using LeafValue = std::function<double(const Node&)>;

  /// Of order 0: the values. Slopes are added to `graph`.
  Series(Graph& graph, std::span<const Expr> roots, LeafValue leaf_value);

  /// Raises the order m by one; `leaf_coefficient` gives the coefficients of order m of the leaves.
  void advance(const LeafValue& leaf_coefficient);

  /// Of a root, up to the order reached.
  const std::vector<double>& of(Expr root) const { return coefficients_.at(root.id()); }

 private:
  struct Terms;

  void follow(Expr x);
  double value(Expr x);
  double computed(Expr x, Terms& terms);

  Graph& graph_;
  LeafValue leaf_value_;
  std::map<NodeId, double> values_;
  std::map<NodeId, std::vector<double>> coefficients_;  ///< of what is followed, by increasing node
  std::size_t order_ = 0;
};

}  // namespace mbcc::graph
