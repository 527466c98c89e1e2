#pragma once
// Derivatives of expressions in one direction, by duals over the graph.

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "graph/graph.hpp"

namespace mbcc::mechanics {

using graph::Expr;
using graph::Kind;

/// d expression / d leaf, for the leaf of that kind and index.
Expr partial(Expr expression, Kind kind, std::uint32_t index);

/// Indices of the leaves of one kind that occur in `expression`, increasing.
std::vector<std::uint32_t> occurring(Expr expression, Kind kind);

/// Structurally nonzero partials along the speeds.
std::map<std::size_t, Expr> partials_along_speeds(Expr expression);

/// The expression with the leaves of kind CoordinateRate replaced by `rates`.
Expr with_rates(Expr expression, const std::vector<Expr>& rates);

/// The motion with u' = 0: t' = 1, q' = kinematics, all else rests.
class UnacceleratedMotion {
 public:
  explicit UnacceleratedMotion(const std::vector<Expr>& kinematics);

  struct Rates {
    Expr first;
    Expr second;
  };
  /// First and second time derivative along the motion.
  Rates rates(Expr expression) const;
  Expr rate(Expr expression) const;

 private:
  const std::vector<Expr>& kinematics_;
  std::vector<Expr> second_;  ///< q'' at u' = 0
};

}  // namespace mbcc::mechanics
