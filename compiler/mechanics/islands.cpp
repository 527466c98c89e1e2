#include "mechanics/islands.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace mbcc::mechanics {

namespace {

/// Disjoint sets of speeds.
class Components {
 public:
  explicit Components(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0); }

  std::size_t root(std::size_t i) {
    while (parents_[i] != i) {
      i = parents_[i] = parents_[parents_[i]];
    }
    return i;
  }
  void join(std::size_t i, std::size_t j) { parents_[root(i)] = root(j); }

 private:
  std::vector<std::size_t> parents_;
};

/// Per row, by position in `rows`: the rows that share a speed with it.
std::vector<std::set<std::size_t>> pattern_of(const std::vector<Row>& all_rows, const std::vector<std::size_t>& rows) {
  std::vector<std::set<std::size_t>> neighbours(rows.size());
  for (const auto& [speed, sharing] : rows_by_speed(all_rows, rows)) {
    for (const std::size_t k : sharing) {
      for (const std::size_t l : sharing) {
        if (l != k) {
          neighbours[k].insert(l);
        }
      }
    }
  }
  return neighbours;
}

/// Rows between two others, no two of them neighbours, greedily in order; none where they are too few for a loop.
std::vector<std::size_t> links_apart(const std::vector<std::set<std::size_t>>& neighbours) {
  constexpr std::size_t few = 16;
  std::vector<std::size_t> apart;
  std::set<std::size_t> taken;
  for (std::size_t k = 0; k < neighbours.size(); ++k) {
    if (neighbours[k].size() == 2 && !taken.contains(*neighbours[k].begin()) &&
        !taken.contains(*neighbours[k].rbegin())) {
      taken.insert(k);
      apart.push_back(k);
    }
  }
  return apart.size() < few ? std::vector<std::size_t>() : apart;
}

}  // namespace

std::vector<Island> find_islands(const std::vector<Row>& rows, const std::vector<Coupling>& couplings,
                                 std::size_t speeds) {
  Components components(speeds);
  for (const Coupling& coupling : couplings) {
    for (const Entry& term : coupling.terms) {
      components.join(term.speed, coupling.speed);
    }
  }
  for (const Row& row : rows) {
    for (const Entry& entry : row.solved) {
      components.join(entry.speed, row.solved.front().speed);
    }
  }
  std::vector<Island> islands;
  std::map<std::size_t, std::size_t> island_of_root;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].solved.empty()) {
      const std::size_t root = components.root(rows[k].solved.front().speed);
      const auto [found, is_new] = island_of_root.try_emplace(root, islands.size());
      if (is_new) {
        islands.emplace_back();
      }
      islands[found->second].rows.push_back(k);
    }
  }
  for (std::size_t j = 0; j < speeds; ++j) {
    const auto found = island_of_root.find(components.root(j));
    if (found != island_of_root.end()) {
      islands[found->second].speeds.push_back(j);
    }
  }
  return islands;
}

std::map<std::size_t, std::vector<std::size_t>> rows_by_speed(const std::vector<Row>& all_rows,
                                                              const std::vector<std::size_t>& rows) {
  std::map<std::size_t, std::vector<std::size_t>> rows_of_speed;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const Entry& entry : all_rows[rows[k]].solved) {
      rows_of_speed[entry.speed].push_back(k);
    }
  }
  return rows_of_speed;
}

std::vector<std::size_t> elimination_order(const std::vector<Row>& all_rows, const std::vector<std::size_t>& rows) {
  std::vector<std::set<std::size_t>> neighbours = pattern_of(all_rows, rows);
  std::set<std::size_t> open;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    open.insert(k);
  }
  std::vector<std::size_t> touched(rows.size());  // when a neighbour was last eliminated
  std::vector<std::size_t> order;
  const auto eliminate = [&](std::size_t next) {
    open.erase(next);
    order.push_back(rows[next]);
    for (const std::size_t k : neighbours[next]) {
      neighbours[k].erase(next);
      touched[k] = order.size();
      for (const std::size_t l : neighbours[next]) {
        if (l != k) {
          neighbours[k].insert(l);
        }
      }
    }
  };
  for (const std::size_t k : links_apart(neighbours)) {
    eliminate(k);
  }
  while (!open.empty()) {
    eliminate(*std::min_element(open.begin(), open.end(), [&](std::size_t k, std::size_t l) {
      return std::tuple(neighbours[k].size(), touched[k], k) < std::tuple(neighbours[l].size(), touched[l], l);
    }));
  }
  return order;
}

}  // namespace mbcc::mechanics
