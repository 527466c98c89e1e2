#pragma once
// Builds System::expressions and knows of every node what it depends on.

#include <cstdint>
#include <initializer_list>
#include <unordered_map>
#include <utility>
#include <vector>

#include "model/system.hpp"
#include "model/value.hpp"

namespace mbcc::model {

/// What an expression depends on: a set of these, joined with `|`.
enum class Quantities : std::uint8_t {
  None = 0,
  Parameter = 1,
  Time = 2,
  Coordinate = 4,
  Speed = 8,
  Acceleration = 16
};

constexpr Quantities operator|(Quantities a, Quantities b) {
  return static_cast<Quantities>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
constexpr bool overlap(Quantities a, Quantities b) {
  return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0;
}

/// Constants are folded: an operation on numbers is a number and leaves no node.
class Arena {
 public:
  Scalar leaf(ExpressionKind kind, std::uint32_t index, Span span);
  /// The result may be infinite or not a number; the caller knows what to say about it.
  Scalar apply(graph::Operator op, std::initializer_list<Scalar> operands, Span span);
  Scalar rate(Scalar operand, Span span);
  /// The coordinates that the components of `position` depend on, increasing.
  std::vector<CoordinateId> coordinates_of(const Value& position) const;
  ExpressionId node(Scalar scalar, Span span);
  Scalar scalar(ExpressionId id) const;  ///< a number again, if it is one

  Quantities quantities(const Scalar& scalar) const {
    return scalar.node ? quantities_[index(*scalar.node)] : Quantities::None;
  }
  /// The innermost node within `scalar`, leftmost first, that brings in one of `unwanted`; there must be one.
  const Expression& source_of(const Scalar& scalar, Quantities unwanted) const;

  std::size_t size() const { return expressions_.size(); }
  const std::vector<Expression>& expressions() const { return expressions_; }
  std::vector<Expression> take() { return std::move(expressions_); }

 private:
  Scalar append(const Expression& expression, Quantities quantities);

  std::vector<Expression> expressions_;
  std::unordered_map<std::uint64_t, ExpressionId> numbers_;  ///< by their bits
  std::vector<Quantities> quantities_;
};

/// Operands that an expression really has.
std::size_t operand_count(const Expression& expression);

}  // namespace mbcc::model
