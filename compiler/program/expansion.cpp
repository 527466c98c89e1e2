#include "program/expansion.hpp"

#include <algorithm>
#include <array>

#include "graph/in_order.hpp"

namespace mbcc::program {

using graph::Kind;
using graph::product_of;

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
  std::size_t& count = product_counts_[static_cast<std::size_t>(pace)];
  const auto [lane, is_new] =
      found_.try_emplace({0, static_cast<std::size_t>(pace), left.id(), right.id(), weighted ? 1U : 0U}, count);
  if (is_new) {
    products_.push_back({pace, left, right, weighted, count++});
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
  std::size_t& count = product_counts_[static_cast<std::size_t>(Pace::Fast)];
  const auto [lane, is_new] = found_.try_emplace({2, static_cast<std::size_t>(pace), entry.id(), constraint, 0}, count);
  if (is_new) {
    reactions_.push_back({pace, entry, constraint, count++});
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
  return number(a, factor_a * factor_b) * (left == right ? squares(left) : product_lane(left, right, false));
}

Expr Expansion::weighted(Expr a, Expr b) {
  const auto [factor_a, rest_a] = split(a);
  const auto [factor_b, rest_b] = split(b);
  return number(a, factor_a * factor_b) * product_lane(rest_a, rest_b, true);
}

/// Before the order that is expanded; fast expansions are of order k + 1 and k + 2, slow ones of k and k + 1.
graph::Row Expansion::newest() const {
  constexpr std::array rows = {graph::Row::Before, graph::Row::Now, graph::Row::Next};
  return rows[shift_];
}

Expr Expansion::product_lane(Expr left, Expr right, bool weighted) {
  const auto lane = static_cast<std::uint32_t>(lanes_.product(pace_, left, right, weighted));
  const bool is_fast = pace_ == Pace::Fast;
  const Kind lefts = is_fast ? Kind::LeftFirst : Kind::SlowLeftFirst;
  const Kind rights = is_fast ? Kind::RightFirst : Kind::SlowRightFirst;
  const Expr older = graph_.leaf(is_fast ? Kind::ProductSum : Kind::SlowProductSum, lane);
  const Expr by_left = product_of({graph_.leaf(lefts, lane), graph_.leaf(row_of(rights, newest()), lane)});
  const Expr by_right = product_of({graph_.leaf(row_of(lefts, newest()), lane), graph_.leaf(rights, lane)});
  return older + by_left + by_right;
}

Expr Expansion::squares(Expr a) {
  const auto [factor, rest] = split(a);
  const auto lane = static_cast<std::uint32_t>(lanes_.square(pace_, rest));
  const bool is_fast = pace_ == Pace::Fast;
  const Kind operands = is_fast ? Kind::SquareFirst : Kind::SlowSquareFirst;
  const Expr older = graph_.leaf(is_fast ? Kind::SquareSum : Kind::SlowSquareSum, lane);
  const Expr newer = product_of({graph_.leaf(operands, lane), graph_.leaf(row_of(operands, newest()), lane)});
  return number(a, 2 * factor * factor) * (older + newer);
}

}  // namespace mbcc::program
