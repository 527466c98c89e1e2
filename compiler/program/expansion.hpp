#pragma once
// Taylor coefficients of expressions as expressions of level Order: Note [recurrences] (graph/recurrence.hpp) over
// Expr.
//
// Note [lanes]: what an expression needs of older coefficients are sums of products. Each distinct sum is a lane; all
// lanes of one kind are computed together, a vector of them at a time, whatever the scene looks like: a lane has its
// own column of operands, so that neighbours need not be related. Three kinds: products, and squares at two paces,
// which cost half as much. The pass of order k (series_plan.hpp) sums
//   left_j right_(k + 2 - j) over 0 < j < k + 2.
// Operands that are known to order k + 1 only later than others are stored one or two rows late on the right, where row
// 1 stays zero: the same sum is then theirs, of an order lower by one or two.

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
  bool weighted;  ///< whether the coefficients on the left are multiplied by their order
};
struct SquareLane {
  Pace pace;
  Expr operand;
  std::size_t index;  ///< among the squares of its pace
};
/// The coefficients of an entry of A times those of a multiplier. `lane` is one of the products.
struct ReactionLane {
  std::size_t lane;
  Pace pace;
  Expr entry;
  std::size_t constraint;
};

/// The lanes of a model. An index is that of the lane's sum.
class Lanes {
 public:
  std::size_t product(Pace pace, Expr left, Expr right, bool weighted);
  std::size_t square(Pace pace, Expr operand);
  std::size_t reaction(Pace pace, Expr entry, std::size_t constraint);

  const std::vector<std::pair<std::size_t, ProductLane>>& products() const { return products_; }
  const std::vector<SquareLane>& squares() const { return squares_; }
  const std::vector<ReactionLane>& reactions() const { return reactions_; }
  std::size_t product_count() const { return products_.size() + reactions_.size(); }
  std::size_t square_count(Pace pace) const { return square_counts_[static_cast<std::size_t>(pace)]; }

 private:
  std::map<std::array<std::size_t, 5>, std::size_t> found_;    ///< index by kind and operands
  std::vector<std::pair<std::size_t, ProductLane>> products_;  ///< with their index
  std::vector<SquareLane> squares_;
  std::vector<ReactionLane> reactions_;
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
