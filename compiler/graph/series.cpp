#include "graph/series.hpp"

#include <array>
#include <utility>

namespace mbcc::graph {

/// What `Recurrences` asks for, at one order. Coefficients below it are known of all that is followed; what is not yet
/// followed begins to be.
struct Series::Terms {
  using Number = double;

  Series& series;
  const LeafValue& leaf_coefficient;
  std::size_t order;
  bool is_search;  ///< for what has to be followed; coefficients do not matter yet

  double value(Expr x) const { return series.value(x); }

  double coefficient(Expr x) {
    const Node node = x.node();
    if (node.kind == Kind::Constant || rests(x)) {
      return 0;
    }
    if (node.kind != Kind::Apply) {
      return leaf_coefficient(node);
    }
    series.follow(x);
    return is_search ? 0 : series.computed(x, *this);
  }

  double sum(Expr a, Expr b, bool weighted) {
    series.follow(a);
    series.follow(b);
    const std::vector<double>& left = series.coefficients_.at(a.id());
    const std::vector<double>& right = series.coefficients_.at(b.id());
    double sum = 0;
    for (std::size_t j = 1; j < order; ++j) {
      sum += (weighted ? static_cast<double>(j) : 1.0) * left[j] * right[order - j];
    }
    return sum;
  }
  double products(Expr a, Expr b) { return sum(a, b, false); }
  double weighted(Expr a, Expr b) { return sum(a, b, true); }
  double squares(Expr a) { return sum(a, a, false); }
  double inverse_order() const { return 1 / static_cast<double>(order); }

  double next(Expr x) {
    return x.node().kind == Kind::Apply && !rests(x) ? Recurrences<Terms>(*this)(x) : coefficient(x);
  }
};

Series::Series(Graph& graph, std::span<const Expr> roots, LeafValue leaf_value)
    : graph_(graph), leaf_value_(std::move(leaf_value)) {
  for (const Expr root : roots) {
    follow(root);
  }
  const LeafValue resting = [](const Node&) { return 0.0; };
  Terms terms{*this, resting, 1, true};
  for (std::size_t before = 0; before != coefficients_.size();) {
    before = coefficients_.size();
    for (const auto& [id, coefficients] : coefficients_) {
      terms.next(graph_.at(id));
    }
  }
}

void Series::advance(const LeafValue& leaf_coefficient) {
  Terms terms{*this, leaf_coefficient, ++order_, false};
  for (const auto& [id, coefficients] : coefficients_) {
    computed(graph_.at(id), terms);
  }
}

/// The coefficient of the order of `terms`, which a node may ask of a later one: a quotient of the reciprocal.
double Series::computed(Expr x, Terms& terms) {
  std::vector<double>& known = coefficients_.at(x.id());
  if (known.size() == terms.order) {
    known.push_back(terms.next(x));
  }
  return known[terms.order];
}

void Series::follow(Expr x) {
  if (coefficients_.contains(x.id())) {
    return;
  }
  for (const NodeId id : reachable(graph_, std::array{x})) {
    coefficients_.try_emplace(id, std::vector<double>{value(graph_.at(id))});
  }
}

double Series::value(Expr x) {
  if (const auto known = values_.find(x.id()); known != values_.end()) {
    return known->second;
  }
  for (const NodeId id : reachable(graph_, std::array{x})) {
    if (values_.contains(id)) {
      continue;
    }
    const Node& node = graph_[id];
    std::array<const double*, 3> operands{};
    for (std::size_t i = 0; i < node.used_operands().size(); ++i) {
      operands[i] = &values_.at(node.operands[i]);
    }
    values_.emplace(id, node.kind == Kind::Constant ? node.value
                        : node.kind == Kind::Apply  ? perform(node.op, operands)
                                                    : leaf_value_(node));
  }
  return values_.at(x.id());
}

}  // namespace mbcc::graph
