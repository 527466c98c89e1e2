#pragma once
// Taylor coefficients of expressions as expressions of level Order: Note [recurrences] (graph/recurrence.hpp) over
// Expr.
//
// Note [lanes]: what an expression needs of older coefficients are sums of products. Each distinct sum is a lane; all
// lanes of one kind are computed together, a vector of them at a time, whatever the scene looks like: a lane has its
// own column of operands, so that neighbours need not be related. Three kinds: products, and squares at two paces,
// which cost half as much. The pass of order k (series_plan.hpp) sums
//   left_j right_(m-j) over 1 < j < m - 1,  m = k + 2 (k + 1 of slow lanes).
// The two terms with the newest operand are left to the expression that uses the sum: the newest operand is then read
// as a number where it was just computed, and the sums do not wait for it. (A vector of numbers that were stored one by
// one is not to be had before they all have reached the cache: measured, half the time of a small scene.) For m = 2
// both are the same term, which the sum takes back once. Of squares it is half the sum, which takes each product once.
// Multipliers are known to order k - 1 only: they are stored two rows late, so that A_(k-j) z_j is a product of order k
// + 2 like the others, whose row 1 on the right is zero.

#include <array>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "graph/recurrence.hpp"

namespace mbcc::program {

using graph::Expr;
using graph::NodeId;

/// How far coefficients are known before the pass of order k solves for accelerations.
enum class Pace {
  Fast,  ///< to k + 1: functions of coordinates and time that constraints need
  Slow,  ///< to k: functions of speeds as well
};

struct ProductLane {
  Pace pace;
  Expr left;
  Expr right;
  bool weighted;      ///< whether the coefficients on the left are multiplied by their order
  std::size_t index;  ///< among the products of its pace
};
struct SquareLane {
  Pace pace;
  Expr operand;
  std::size_t index;  ///< among the squares of its pace
};
/// The coefficients of an entry of A times those of a multiplier: one of the fast products.
struct ReactionLane {
  Pace pace;  ///< of the entry
  Expr entry;
  std::size_t constraint;
  std::size_t index;
};

/// The lanes of a model. An index is that of the lane's sum.
class Lanes {
 public:
  std::size_t product(Pace pace, Expr left, Expr right, bool weighted);
  std::size_t square(Pace pace, Expr operand);
  std::size_t reaction(Pace pace, Expr entry, std::size_t constraint);

  const std::vector<ProductLane>& products() const { return products_; }
  const std::vector<SquareLane>& squares() const { return squares_; }
  const std::vector<ReactionLane>& reactions() const { return reactions_; }
  std::size_t product_count(Pace pace) const { return product_counts_[static_cast<std::size_t>(pace)]; }
  std::size_t square_count(Pace pace) const { return square_counts_[static_cast<std::size_t>(pace)]; }

 private:
  std::map<std::array<std::size_t, 5>, std::size_t> found_;  ///< index by kind and operands
  std::vector<ProductLane> products_;
  std::vector<SquareLane> squares_;
  std::vector<ReactionLane> reactions_;
  std::array<std::size_t, 2> product_counts_{};  ///< by pace
  std::array<std::size_t, 2> square_counts_{};
};

/// Coefficients of one order. A pace and a shift say which: the order is k + shift in the pass of order k.
class Expansion {
 public:
  /// What the coefficients of that order are for the leaves; the constant 0 for those that rest.
  using Leaf = std::function<Expr(const graph::Node&)>;

  Expansion(graph::Graph& graph, Lanes& lanes, Pace pace, std::uint32_t shift, Leaf leaf)
      : graph_(graph), lanes_(lanes), pace_(pace), shift_(shift), leaf_(std::move(leaf)) {}

  using Number = Expr;
  Expr value(Expr x) const { return x; }
  Expr coefficient(Expr x);
  Expr products(Expr a, Expr b);
  Expr weighted(Expr a, Expr b);
  Expr squares(Expr a);
  Expr order() { return graph_.leaf(graph::Kind::Order, shift_); }
  Expr inverse_order() { return graph_.leaf(graph::Kind::InverseOrder, shift_); }

 private:
  Expr product_lane(Expr left, Expr right, bool weighted);
  graph::Row newest() const;
  Expr keep(Expr x);
  Expr computed(Expr x);

  graph::Graph& graph_;
  Lanes& lanes_;
  const Pace pace_;
  const std::uint32_t shift_;
  const Leaf leaf_;
  std::unordered_map<NodeId, Expr> coefficients_;
};

}  // namespace mbcc::program
