#pragma once
// Note [order of nodes]: C++ leaves open which operand of `f() * g()` is formed first, and the graph orders nodes by
// their making: the order reaches the emitted text. Where both operands may make nodes they are listed in braces,
// whose order is defined, so that every build of mbcc writes the same program. Constants need none of this: they come
// first in sums and products wherever they were made.

namespace mbcc::graph {

template <class T>
T sum_of(const T (&operands)[2]) {
  return operands[0] + operands[1];
}
template <class T>
T difference_of(const T (&operands)[2]) {
  return operands[0] - operands[1];
}
template <class T>
T product_of(const T (&operands)[2]) {
  return operands[0] * operands[1];
}
template <class T>
T quotient_of(const T (&operands)[2]) {
  return operands[0] / operands[1];
}

}  // namespace mbcc::graph
