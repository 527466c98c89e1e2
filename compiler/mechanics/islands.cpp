#include "mechanics/islands.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <algorithm>
#include <map>
#include <numeric>

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

}  // namespace

std::vector<Island> find_islands(const std::vector<Row>& rows, std::size_t speeds) {
  Components components(speeds);
  for (const Row& row : rows) {
    for (const Entry& entry : row.entries) {
      components.join(entry.speed, row.entries.front().speed);
    }
  }
  std::vector<Island> islands;
  std::map<std::size_t, std::size_t> island_of_root;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!rows[k].entries.empty()) {
      const std::size_t root = components.root(rows[k].entries.front().speed);
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

std::vector<std::size_t> elimination_order(const std::vector<Row>& all_rows, const std::vector<std::size_t>& rows) {
  std::map<std::size_t, std::vector<int>> rows_of_speed;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    for (const Entry& entry : all_rows[rows[k]].entries) {
      rows_of_speed[entry.speed].push_back(static_cast<int>(k));
    }
  }
  std::vector<Eigen::Triplet<double>> pattern;
  for (const auto& [speed, sharing] : rows_of_speed) {
    for (const int k : sharing) {
      for (const int l : sharing) {
        pattern.emplace_back(k, l, 1.0);
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(rows.size());
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.setFromTriplets(pattern.begin(), pattern.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> permutation;
  Eigen::AMDOrdering<int>()(matrix, permutation);

  std::vector<std::size_t> ordered;
  for (Eigen::Index k = 0; k < size; ++k) {
    ordered.push_back(rows[static_cast<std::size_t>(permutation.indices()[k])]);
  }
  return ordered;
}

}  // namespace mbcc::mechanics
