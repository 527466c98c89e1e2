#pragma once
// What an expression of the language comes to: a number or a vector, whose components are known or are nodes.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "model/system.hpp"

namespace mbcc::model {

/// A number known when compiling, or a node of the arena.
struct Scalar {
  double number = 0;
  std::optional<ExpressionId> node;

  bool is_number() const { return !node; }
  bool is_zero() const { return !node && number == 0; }
};

/// A scalar, a vector of two or three components, or nothing: the value of an expression that has been reported.
/// Whatever is computed from nothing is nothing, silently.
class Value {
 public:
  Value() = default;
  Value(Scalar scalar) : size_(1), components_{scalar} {}
  Value(double number) : Value(Scalar{number, std::nullopt}) {}

  bool is_nothing() const { return size_ == 0; }
  bool is_scalar() const { return size_ == 1; }
  bool is_vector() const { return size_ > 1; }
  /// The number 0, which counts as a vector of zeros wherever a vector is expected.
  bool is_zero() const { return is_scalar() && components_[0].is_zero(); }
  bool is_number() const { return is_scalar() && components_[0].is_number(); }

  std::size_t size() const { return size_; }
  const Scalar& operator[](std::size_t i) const { return components_[i]; }
  const Scalar* begin() const { return components_.data(); }
  const Scalar* end() const { return components_.data() + size_; }
  void append(const Scalar& component) { components_[size_++] = component; }

 private:
  std::size_t size_ = 0;
  std::array<Scalar, 3> components_{};
};

/// "a number", "a vector of 3 components".
std::string describe(const Value& value);

}  // namespace mbcc::model
