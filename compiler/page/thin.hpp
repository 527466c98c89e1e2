#pragma once
// Fewer rows of a long result, such that curves keep their look.

#include <cstddef>
#include <vector>

namespace mbcc::page {

/// At most about `wanted` rows of `columns` (the first is time), increasing, the first and the last among them; all of
/// them if they are no more. The rows are cut into stretches; each gives its first row, and the one that is farthest
/// from the straight line between the stretch's ends in any column, measured by that column's range: peaks stay.
std::vector<std::size_t> thin(const std::vector<std::vector<double>>& columns, std::size_t wanted);

}  // namespace mbcc::page
