#pragma once
// Random expressions over the whole operator table, exactly as drawn: nothing is folded.

#include <span>
#include <vector>

#include "graph/graph.hpp"
#include "random.hpp"

namespace mbcc::test {

/// Half of the operators drawn are arithmetic, as in models; comparisons occur as conditions of `if` alone, and only
/// positive bases have exponents that vary.
class RandomExpressions {
 public:
  RandomExpressions(graph::Graph& graph, std::vector<graph::Expr> leaves, Random& random)
      : graph_(graph), leaves_(std::move(leaves)), random_(random) {}

  graph::Expr draw(int depth) {
    if (depth == 0 || random_.chance(0.15)) {
      return random_.chance(0.3) ? constant() : random_.pick(leaves_);
    }
    const graph::OperatorRow& row = random_.chance(0.5) ? random_.pick(std::span(graph::operator_table).first(6))
                                                        : random_.pick(graph::operator_table);
    if (row.op == graph::Operator::If) {
      return intern(row.op, {condition(depth - 1), draw(depth - 1), draw(depth - 1)});
    }
    if (is_comparison(row.op)) {
      return draw(depth);
    }
    if (row.op == graph::Operator::Power) {
      return random_.chance(0.7) ? intern(row.op, {draw(depth - 1), graph_.constant(whole(-3, 5))})
                                 : intern(row.op, {intern(graph::Operator::Exp, {draw(depth - 1)}), draw(depth - 1)});
    }
    return row.arity == 1 ? intern(row.op, {draw(depth - 1)}) : intern(row.op, {draw(depth - 1), draw(depth - 1)});
  }

 private:
  static bool is_comparison(graph::Operator op) {
    return op == graph::Operator::Less || op == graph::Operator::LessEqual || op == graph::Operator::Equal;
  }

  double whole(int low, int high) {
    return low + static_cast<double>(random_.below(static_cast<std::size_t>(high - low + 1)));
  }
  graph::Expr condition(int depth) {
    const auto op = random_.chance(0.5) ? graph::Operator::Less : graph::Operator::LessEqual;
    return intern(op, {draw(depth), draw(depth)});
  }
  graph::Expr constant() {
    static constexpr std::array values = {-2.0, -1.0, 0.0, 0.5, 1.0, 2.0, 3.0, 0.7, -1.3};
    return graph_.constant(random_.pick(values));
  }
  graph::Expr intern(graph::Operator op, const std::vector<graph::Expr>& operands) {
    return graph_.intern(op, operands);
  }

  graph::Graph& graph_;
  std::vector<graph::Expr> leaves_;
  Random& random_;
};

}  // namespace mbcc::test
