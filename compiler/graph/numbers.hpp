#pragma once
// The operators over plain numbers: double, long double, __float128-like types. The elementary functions are the
// number type's own; here are the ones that it does not have.

#include <cmath>

namespace mbcc::graph {

class Expr;
template <class T>
struct Dual;
class Feed;

template <class T>
inline constexpr bool is_plain_number = true;
template <>
inline constexpr bool is_plain_number<Expr> = false;
template <>
inline constexpr bool is_plain_number<Feed> = false;
template <class T>
inline constexpr bool is_plain_number<Dual<T>> = false;

template <class T>
concept PlainNumber = is_plain_number<T>;

/// The constant x in the algebra of `like`.
template <PlainNumber T>
T number(const T& /*like*/, double x) {
  return T(x);
}
/// Whether a derivative is known to be zero, so that its term need not be formed.
template <PlainNumber T>
bool is_zero(const T& x) {
  return x == T(0);
}

// min and max let a NaN of either operand pass.
// clang-format off
template <PlainNumber T> T add(const T& a, const T& b) { return a + b; }
template <PlainNumber T> T subtract(const T& a, const T& b) { return a - b; }
template <PlainNumber T> T multiply(const T& a, const T& b) { return a * b; }
template <PlainNumber T> T divide(const T& a, const T& b) { return a / b; }
template <PlainNumber T> T negate(const T& a) { return -a; }
template <PlainNumber T> T sign(const T& a) { return a > T(0) ? T(1) : a < T(0) ? T(-1) : a; }
template <PlainNumber T> T minimum(const T& a, const T& b) { return a <= b || a != a ? a : b; }
template <PlainNumber T> T maximum(const T& a, const T& b) { return b <= a || a != a ? a : b; }
template <PlainNumber T> T less(const T& a, const T& b) { return T(a < b ? 1 : 0); }
template <PlainNumber T> T less_equal(const T& a, const T& b) { return T(a <= b ? 1 : 0); }
template <PlainNumber T> T equal(const T& a, const T& b) { return T(a == b ? 1 : 0); }
template <PlainNumber T> T select(const T& a, const T& b, const T& c) { return a != T(0) ? b : c; }
// clang-format on

}  // namespace mbcc::graph

/// Makes the elementary functions of plain numbers visible beside the ones that argument-dependent lookup finds.
#define MBCC_USING_ELEMENTARY_FUNCTIONS                                                                          \
  using std::abs, std::acos, std::acosh, std::asin, std::asinh, std::atan, std::atan2, std::atanh, std::cos,     \
      std::cosh, std::exp, std::hypot, std::log, std::log10, std::pow, std::sin, std::sinh, std::sqrt, std::tan, \
      std::tanh
