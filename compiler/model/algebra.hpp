#pragma once
// Arithmetic on values: component by component, with the rules of numbers and vectors.

#include <unordered_map>

#include "model/context.hpp"

namespace mbcc::model {

/// A value and where it is written.
struct Operand {
  Value value;
  Span span;
};

/// Every function reports what is wrong with its operands and then returns nothing. `whole` is the span of the result,
/// `sign` that of the operator.
class Algebra {
 public:
  explicit Algebra(Context& context) : context_(context) {}

  Value negate(const Operand& operand, Span whole);
  /// `+` and `-`. The number 0 counts as a vector of zeros.
  Value add(const Operand& left, const Operand& right, Span sign, Span whole);
  Value subtract(const Operand& left, const Operand& right, Span sign, Span whole);
  Value multiply(const Operand& left, const Operand& right, Span sign, Span whole);
  Value divide(const Operand& left, const Operand& right, Span whole);
  Value power(const Operand& base, const Operand& exponent, Span whole);

  Value dot(const Operand& left, const Operand& right, Span whole);
  Value cross(const Operand& left, const Operand& right, Span whole);
  Value norm(const Operand& operand, Span whole);

  /// `yes` where `condition` is not 0, else `no`.
  Value choose(Scalar condition, const Operand& yes, const Operand& no, Span whole);
  /// Of numbers, as many as the operator takes; `what` describes an operand ("the argument of `sin`").
  Value apply(graph::Operator op, std::initializer_list<Operand> operands, std::string_view what, Span whole);
  Value rate(const Value& value, Span whole);

  /// Reports anything but a number. False also for nothing.
  bool expect_number(const Operand& operand, std::string_view what);
  /// As many components as the dimension; the number 0 stands for zeros. Nothing, with a finding, for other values.
  Value expect_vector(const Operand& operand, std::string_view what);
  /// False, with a finding, if the value depends on one of `unwanted`.
  bool expect_independent(const Operand& operand, Quantities unwanted, std::string_view what);

 private:
  Value sum(graph::Operator op, const Operand& left, const Operand& right, Span sign, Span whole);
  std::optional<Scalar> product(const Scalar& a, const Scalar& b, Span whole);
  /// A component of a result; empty, with a finding, if it is a number out of range.
  std::optional<Scalar> compute(graph::Operator op, std::initializer_list<Scalar> operands, Span whole);
  /// The value whose components are `component(i)`; nothing, if one of them is missing.
  template <class Component>
  static Value each(std::size_t size, const Component& component) {
    Value result;
    for (std::size_t i = 0; i < size; ++i) {
      const std::optional<Scalar> computed = component(i);
      if (!computed) {
        return {};
      }
      result.append(*computed);
    }
    return result;
  }

  Context& context_;
  std::unordered_map<std::uint32_t, Scalar> squares_of_norms_;  ///< so that norm(v)^2 needs no root
};

}  // namespace mbcc::model
