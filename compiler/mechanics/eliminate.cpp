#include "mechanics/eliminate.hpp"

#include <algorithm>
#include <map>

namespace mbcc::mechanics {

namespace {

/// A sparse column or row: position in the elimination order to value, structural zeros absent.
using Sparse = std::map<std::size_t, Expr>;

/// sum over the speeds that both rows have of A_kj A_lj / m_j; nothing if they share none.
std::optional<Expr> product(const Row& k, const Row& l, const std::vector<Expr>& mobility) {
  std::optional<Expr> sum;
  auto left = k.entries.begin();
  auto right = l.entries.begin();
  while (left != k.entries.end() && right != l.entries.end()) {
    if (left->speed < right->speed) {
      ++left;
    } else if (right->speed < left->speed) {
      ++right;
    } else {
      const Expr term = left->value * right->value * mobility[left->speed];
      sum = sum ? *sum + term : term;
      ++left;
      ++right;
    }
  }
  return sum;
}

/// Lower triangle of S by columns, each with its diagonal; only rows that share a speed are paired.
std::vector<Sparse> assemble(const Island& island, const Derivatives& derivatives) {
  std::map<std::size_t, std::vector<std::size_t>> rows_of_speed;
  for (std::size_t k = 0; k < island.rows.size(); ++k) {
    for (const Entry& entry : derivatives.rows[island.rows[k]].entries) {
      rows_of_speed[entry.speed].push_back(k);
    }
  }
  std::vector<Sparse> columns(island.rows.size());
  for (const auto& [speed, sharing] : rows_of_speed) {
    for (const std::size_t k : sharing) {
      for (const std::size_t l : sharing) {
        if (l >= k && !columns[k].contains(l)) {
          const auto entry =
              product(derivatives.rows[island.rows[k]], derivatives.rows[island.rows[l]], derivatives.mobility);
          if (entry && (l == k || !is_zero(*entry))) {
            columns[k].emplace(l, *entry);
          }
        }
      }
    }
  }
  return columns;
}

void subtract_from(Sparse& column, std::size_t position, Expr term) {
  const auto [found, is_new] = column.try_emplace(position, -term);
  if (!is_new) {
    found->second = found->second - term;
  }
}

}  // namespace

Elimination eliminate(const Island& island, const Derivatives& derivatives, graph::Graph& graph) {
  const std::size_t size = island.rows.size();
  std::vector<Sparse> columns = assemble(island, derivatives);  // becomes L D, column by column
  Elimination result;
  std::vector<Sparse> factor(size);  // L below its unit diagonal
  for (std::size_t k = 0; k < size; ++k) {
    result.pivots.push_back({island.rows[k], columns[k].at(k), columns[k].at(k)});
    result.forward.push_back(derivatives.rows[island.rows[k]].residual);
  }
  for (std::size_t k = 0; k < size; ++k) {
    const Expr pivot = columns[k].at(k);
    result.pivots[k].pivot = pivot;
    for (const auto& [i, entry] : columns[k]) {
      if (i == k) {
        continue;
      }
      const Expr multiplier = entry / pivot;
      factor[k].emplace(i, multiplier);
      for (const auto& [j, other] : columns[k]) {
        if (j >= i) {
          subtract_from(columns[i], j, multiplier * other);
        }
      }
      result.forward[i] = result.forward[i] - multiplier * result.forward[k];
    }
  }
  result.multipliers.assign(size, graph.constant(0));
  for (std::size_t k = size; k-- > 0;) {
    Expr z = result.forward[k] / columns[k].at(k);
    for (const auto& [i, multiplier] : factor[k]) {
      z = z - multiplier * result.multipliers[i];
    }
    result.multipliers[k] = z;
  }
  for (const std::size_t speed : island.speeds) {
    result.added.push_back(graph.constant(0));
    for (std::size_t k = 0; k < size; ++k) {
      for (const Entry& entry : derivatives.rows[island.rows[k]].entries) {
        if (entry.speed == speed) {
          result.added.back() = result.added.back() + entry.value * result.multipliers[k];
        }
      }
    }
    result.added.back() = result.added.back() * derivatives.mobility[speed];
  }
  return result;
}

}  // namespace mbcc::mechanics
