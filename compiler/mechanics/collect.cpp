#include "mechanics/collect.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace mbcc::mechanics {

namespace {

using graph::Expr;
using graph::Kind;
using graph::Operator;

/// coefficient * value, in the order in which the values occur in the sum.
struct Term {
  double coefficient;
  Expr value;
};

class Collector {
 public:
  void add(double coefficient, Expr x) {
    const double factor = numeric_factor(x);
    if (x.is_constant() || (factor != 1 && factor != 0)) {
      const Expr rest = x.is_constant() ? number(x, 1) : x / number(x, factor);
      add_rest(coefficient * (x.is_constant() ? x.node().value : factor), rest);
    } else {
      add_rest(coefficient, x);
    }
  }

  Expr sum(Expr like) const {
    Expr total = number(like, 0);
    std::vector<double> sizes;
    for (const Term& term : terms_) {
      const double size = std::abs(term.coefficient);
      if (size != 0 && std::find(sizes.begin(), sizes.end(), size) == sizes.end()) {
        sizes.push_back(size);
      }
    }
    for (const double size : sizes) {
      total = total + number(like, size) * sum_of_size(size, like);
    }
    return total;
  }

 private:
  /// `x` has no numeric factor of its own.
  void add_rest(double coefficient, Expr x) {
    const graph::Node node = x.node();
    if (node.kind == Kind::Apply && (node.op == Operator::Add || node.op == Operator::Subtract)) {
      add(coefficient, x.graph().at(node.operands[0]));
      add(node.op == Operator::Add ? coefficient : -coefficient, x.graph().at(node.operands[1]));
      return;
    }
    const auto same = std::find_if(terms_.begin(), terms_.end(), [&](const Term& term) { return term.value == x; });
    if (same == terms_.end()) {
      terms_.push_back({coefficient, x});
    } else {
      same->coefficient += coefficient;
    }
  }

  Expr sum_of_size(double size, Expr like) const {
    Expr sum = number(like, 0);
    for (const Term& term : terms_) {
      if (std::abs(term.coefficient) == size) {
        sum = term.coefficient > 0 ? sum + term.value : sum - term.value;
      }
    }
    return sum;
  }

  std::vector<Term> terms_;
};

}  // namespace

Expr collect(Expr sum) {
  Collector collector;
  collector.add(1, sum);
  return collector.sum(sum);
}

}  // namespace mbcc::mechanics
