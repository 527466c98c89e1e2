#pragma once
// What has to be solved together, and in which order.

#include <vector>

#include "mechanics/derivatives.hpp"

namespace mbcc::mechanics {

/// Connected components of the speeds, joined by the rows in which they occur, in the order of their first row; each
/// with its rows in an order of approximate minimum degree. Rows without entries belong to no island.
std::vector<Island> find_islands(const std::vector<Row>& rows, std::size_t speeds);

}  // namespace mbcc::mechanics
