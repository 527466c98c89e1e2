#pragma once
// The paper's FEED form (fast and efficient evaluation of derivatives) over double: the value of an expression with
// all its first and all its second partial derivatives. mbcc differentiates by duals; this is the independent oracle
// for A and b, and what `mbcc dump --partials` shows.

#include <vector>

#include "graph/dual.hpp"

namespace mbcc::graph {

/// Value, gradient and Hessian with respect to n variables; the Hessian is empty where only first order is carried,
/// as the paper does for nonholonomic constraints.
class Feed {
 public:
  enum class Order { First, Second };

  static Feed constant(double value, std::size_t variables, Order order);
  static Feed variable(double value, std::size_t which, std::size_t variables, Order order);

  double value() const { return value_; }
  double first(std::size_t i) const { return first_[i]; }
  double second(std::size_t i, std::size_t j) const { return second_[packed(i, j)]; }
  std::size_t variables() const { return first_.size(); }

  /// The chain rule to second order for `op` applied to `operands`.
  static Feed chain(Operator op, const std::array<const Feed*, 3>& operands);

 private:
  static std::size_t packed(std::size_t i, std::size_t j) { return i < j ? packed(j, i) : i * (i + 1) / 2 + j; }

  double value_ = 0;
  std::vector<double> first_;
  std::vector<double> second_;  ///< lower triangle by rows
};

#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  inline Feed function(const Feed& a) { return Feed::chain(Operator::name, {&a, nullptr, nullptr}); }
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  inline Feed function(const Feed& a, const Feed& b) { return Feed::chain(Operator::name, {&a, &b, nullptr}); }
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  inline Feed function(const Feed& a, const Feed& b, const Feed& c) {                         \
    return Feed::chain(Operator::name, {&a, &b, &c});                                         \
  }
#include "graph/operators.def"

}  // namespace mbcc::graph
