#pragma once
// Expressions of a lowered graph as C++ text with no more parentheses than needed.

#include <string>
#include <vector>

#include "graph/graph.hpp"

namespace mbcc::cpp {

/// How tightly a piece of C++ text binds, loosest first.
enum class Binding { Conditional, Comparison, Sum, Product, Prefix, Primary };

struct Code {
  std::string text;
  Binding binding = Binding::Primary;
};

/// A double that reads back as the same double, with a point or an exponent.
Code literal(double value);

/// `op` applied to code of its operands.
Code compose(graph::Operator op, const std::vector<Code>& operands);

/// `first + stride * i` without what is nothing: "4", "i", "3 * i + 4", "98 - 2 * i".
std::string affine(long first, long stride, const std::string& i);

}  // namespace mbcc::cpp
