#pragma once
// What has to be solved together, and in which order.

#include <map>
#include <vector>

#include "mechanics/derivatives.hpp"

namespace mbcc::mechanics {

/// Connected components of the speeds, joined by inertia and by the rows in which they occur, in the order of their
/// first row; each with its rows in the order of the model. Rows without entries belong to no island.
std::vector<Island> find_islands(const std::vector<Row>& rows, const std::vector<Coupling>& couplings,
                                 std::size_t speeds);

/// Per speed that occurs in `rows`, some of `all_rows`: the positions in `rows` of those in which it does, increasing.
std::map<std::size_t, std::vector<std::size_t>> rows_by_speed(const std::vector<Row>& all_rows,
                                                              const std::vector<std::size_t>& rows);

/// `rows`, some of `all_rows`, in an order of minimum degree of the pattern of A M^-1 A^T.
///
/// Among rows of equal degree the one goes first whose neighbours were eliminated longest ago: a chain is eaten from
/// both ends at once, which halves the length of the dependent divisions (measured: 25 to 30 % of the time of a chain).
/// A library's ordering minimises fill alone, and runs along the chain. In a long chain every second row goes before
/// all others: these do not depend on each other, become one loop, and leave a chain of half the length (measured, 100
/// links: 12 % of a step, though it takes half as many operations more).
std::vector<std::size_t> elimination_order(const std::vector<Row>& all_rows, const std::vector<std::size_t>& rows);

}  // namespace mbcc::mechanics
