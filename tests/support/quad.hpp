#pragma once
// Quadruple precision, as an algebra for graph::evaluate.

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "graph/dual.hpp"

namespace mbcc::test {

using Quad = boost::multiprecision::cpp_bin_float_quad;

}  // namespace mbcc::test
