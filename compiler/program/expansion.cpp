#include "program/expansion.hpp"

#include <algorithm>
#include <array>

namespace mbcc::program {

using graph::Kind;

namespace {

/// The sum of a lane whose operands may have numeric factors of their own.
struct Factored {
  double factor;
  Expr rest;
};

Factored split(Expr x) {
  const double factor = numeric_factor(x);
  return factor == 0 || x.is_constant() ? Factored{1, x} : Factored{factor, x / number(x, factor)};
}

}  // namespace

std::size_t Lanes::product(Pace pace, Expr left, Expr right, bool weighted) {
  const auto [lane, is_new] = found_.try_emplace(
      {0, static_cast<std::size_t>(pace), left.id(), right.id(), weighted ? 1U : 0U}, product_count());
  if (is_new) {
    products_.emplace_back(lane->second, ProductLane{pace, left, right, weighted});
  }
  return lane->second;
}

std::size_t Lanes::square(Pace pace, Expr operand) {
  std::size_t& count = square_counts_[static_cast<std::size_t>(pace)];
  const auto [lane, is_new] = found_.try_emplace({1, static_cast<std::size_t>(pace), operand.id(), 0, 0}, count);
  if (is_new) {
    squares_.push_back({pace, operand, count++});
  }
  return lane->second;
}

std::size_t Lanes::reaction(Pace pace, Expr entry, std::size_t constraint) {
  const auto [lane, is_new] =
      found_.try_emplace({2, static_cast<std::size_t>(pace), entry.id(), constraint, 0}, product_count());
  if (is_new) {
    reactions_.push_back({lane->second, pace, entry, constraint});
  }
  return lane->second;
}

Expr Expansion::coefficient(Expr x) {
  if (const auto known = coefficients_.find(x.id()); known != coefficients_.end()) {
    return known->second;
  }
  // Sums and products in order, since they may be long; the rest as they ask for it, since they skip operands.
  for (const NodeId id : graph::reachable(graph_, std::array{x})) {
    const graph::Node& node = graph_[id];
    const bool is_long = node.kind == Kind::Apply && (graph::row(node.op).recurrence == graph::Recurrence::Linear ||
                                                      graph::row(node.op).recurrence == graph::Recurrence::Product);
    if (is_long && !coefficients_.contains(id)) {
      keep(graph_.at(id));
    }
  }
  return keep(x);
}

Expr Expansion::keep(Expr x) {
  const auto known = coefficients_.find(x.id());
  if (known != coefficients_.end()) {
    return known->second;
  }
  const Expr found = computed(x);
  coefficients_.emplace(x.id(), found);
  return found;
}

Expr Expansion::computed(Expr x) {
  if (rests(x)) {
    return graph_.constant(0);
  }
  return x.node().kind == Kind::Apply ? graph::Recurrences<Expansion>(*this)(x) : leaf_(graph::Node(x.node()));
}

Expr Expansion::products(Expr a, Expr b) {
  const auto [factor_a, rest_a] = split(a);
  const auto [factor_b, rest_b] = split(b);
  const auto [left, right] = std::minmax(rest_a, rest_b);
  if (left == right) {
    return number(a, factor_a * factor_b) * squares(left);
  }
  const std::size_t lane = lanes_.product(pace_, left, right, false);
  return number(a, factor_a * factor_b) * graph_.leaf(Kind::ProductSum, static_cast<std::uint32_t>(lane));
}

Expr Expansion::weighted(Expr a, Expr b) {
  const auto [factor_a, rest_a] = split(a);
  const auto [factor_b, rest_b] = split(b);
  const std::size_t lane = lanes_.product(pace_, rest_a, rest_b, true);
  return number(a, factor_a * factor_b) * graph_.leaf(Kind::ProductSum, static_cast<std::uint32_t>(lane));
}

Expr Expansion::squares(Expr a) {
  const auto [factor, rest] = split(a);
  const std::size_t lane = lanes_.square(pace_, rest);
  const Kind kind = pace_ == Pace::Fast ? Kind::SquareSum : Kind::SlowSquareSum;
  return number(a, factor * factor) * graph_.leaf(kind, static_cast<std::uint32_t>(lane));
}

}  // namespace mbcc::program
