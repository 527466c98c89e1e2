#include "mechanics/eliminate.hpp"

#include <algorithm>
#include <map>

#include "graph/in_order.hpp"
#include "mechanics/islands.hpp"
#include "mechanics/uncouple.hpp"

namespace mbcc::mechanics {

namespace {

using graph::difference_of;
using graph::product_of;

/// A sparse column or row: position in the elimination order to value, structural zeros absent.
using Sparse = std::map<std::size_t, Expr>;

/// sum over the speeds that both rows have of A_kj A_lj / m_j; nothing if they share none. Equal terms are counted, not
/// added: the two ends of a rod contribute alike.
std::optional<Expr> product(const Row& k, const Row& l, const std::vector<Expr>& mobility) {
  std::vector<std::pair<Expr, int>> terms;
  auto left = k.solved.begin();
  auto right = l.solved.begin();
  while (left != k.solved.end() && right != l.solved.end()) {
    if (left->speed < right->speed) {
      ++left;
    } else if (right->speed < left->speed) {
      ++right;
    } else {
      const Expr term = product_of({as_solved(k, left->value), as_solved(l, right->value)}) * mobility[left->speed];
      const auto same =
          std::find_if(terms.begin(), terms.end(), [&](const auto& other) { return other.first == term; });
      if (same == terms.end()) {
        terms.emplace_back(term, 1);
      } else {
        ++same->second;
      }
      ++left;
      ++right;
    }
  }
  std::optional<Expr> sum;
  for (const auto& [term, count] : terms) {
    const Expr multiple = number(term, count) * term;
    sum = sum ? *sum + multiple : multiple;
  }
  return sum;
}

/// Lower triangle of S by columns, each with its diagonal; only rows that share a speed are paired.
std::vector<Sparse> assemble(const Island& island, const Derivatives& derivatives) {
  std::vector<Sparse> columns(island.rows.size());
  for (const auto& [speed, sharing] : rows_by_speed(derivatives.rows, island.rows)) {
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

/// Fills `rows` and `couplings`.
void list_in_model_order(const Island& island, const Derivatives& derivatives, const std::vector<Sparse>& columns,
                         Elimination& result) {
  std::map<std::size_t, std::map<std::size_t, Expr>> entries;  // by row, then by earlier row
  for (std::size_t k = 0; k < columns.size(); ++k) {
    for (const auto& [l, entry] : columns[k]) {
      const auto [earlier, later] = std::minmax(island.rows[k], island.rows[l]);
      entries[later].emplace(earlier, entry);
    }
  }
  for (const auto& [row, of_row] : entries) {
    const Row& own = derivatives.rows[row];
    result.rows.push_back({as_solved(own, own.residual), of_row.at(row)});
    std::vector<Expr> coupled;
    for (const auto& [earlier, entry] : of_row) {
      if (earlier != row) {
        coupled.push_back(entry);
      }
    }
    if (!coupled.empty()) {
      result.couplings.push_back(std::move(coupled));
    }
  }
}

void subtract_from(Sparse& column, std::size_t position, Expr term) {
  const auto [found, is_new] = column.try_emplace(position, -term);
  if (!is_new) {
    found->second = found->second - term;
  }
}

/// u' = a + M^-1 A^T z per speed of the island, terms in the order of the model. A free acceleration along an entry of
/// A (a central force, and the sphere that it meets) joins that entry's term.
void accelerate(const Island& island, const Derivatives& derivatives, Elimination& result, graph::Graph& graph) {
  std::map<std::size_t, Expr> multiplier_of;  // by row, in the order of the model
  for (std::size_t k = 0; k < island.rows.size(); ++k) {
    multiplier_of.emplace(island.rows[k], result.multipliers[k]);
  }
  std::vector<Expr> free = derivatives.free;
  std::map<std::size_t, Expr> added;
  for (const auto& [row, multiplier] : multiplier_of) {
    std::vector<Expr>& terms = result.constraint_terms.emplace_back();
    for (const Entry& entry : derivatives.rows[row].solved) {
      const Expr along = as_solved(derivatives.rows[row], entry.value) * derivatives.mobility[entry.speed];
      const Expr ratio = free[entry.speed] / along;
      const bool joins = ratio.is_constant();
      if (joins) {
        free[entry.speed] = graph.constant(0);
      }
      const Expr term = along * (joins ? multiplier + ratio : multiplier);
      terms.push_back(term);
      const auto [found, is_new] = added.try_emplace(entry.speed, term);
      if (!is_new) {
        found->second = found->second + term;
      }
    }
  }
  for (const std::size_t speed : island.speeds) {
    const auto found = added.find(speed);
    result.accelerations.push_back(found == added.end() ? free[speed] : free[speed] + found->second);
  }
}

/// LDL^T with the multipliers z of the solution.
void eliminate_in_order(std::vector<Sparse>& columns, Elimination& result) {
  const std::size_t size = columns.size();
  std::vector<Sparse> factor(size);  // L below its unit diagonal
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
  for (std::size_t k = 0; k < size; ++k) {
    result.quotients.push_back(result.forward[k] / columns[k].at(k));
  }
  for (std::size_t k = size; k-- > 0;) {
    Expr z = result.quotients[k];
    for (const auto& [i, multiplier] : factor[k]) {
      z = z - multiplier * result.multipliers[i];
    }
    result.multipliers[k] = z;
  }
}

/// Two coupled rows by the determinant: one division where LDL^T needs three. The second pivot and its diagonal are
/// both multiplied by the first: det S = d_2 S_11 against S_22 S_11.
void eliminate_two(const std::vector<Sparse>& columns, Elimination& result) {
  const Expr first = columns[0].at(0);
  const Expr coupling = columns[0].at(1);
  const Expr second = columns[1].at(1);
  const Expr determinant = difference_of({first * second, coupling * coupling});
  const Expr reciprocal = number(first, 1) / determinant;
  const Expr r1 = result.forward[0];
  const Expr r2 = result.forward[1];
  result.pivots[1] = {result.pivots[1].row, first * second, determinant, first};
  result.multipliers = {difference_of({second * r1, coupling * r2}) * reciprocal,
                        difference_of({first * r2, coupling * r1}) * reciprocal};
}

/// The entry of A along `speed`, divided by the row's content; zero where the row has none.
Expr entry_along(const Row& row, std::size_t speed) {
  for (const Entry& entry : row.solved) {
    if (entry.speed == speed) {
      return as_solved(row, entry.value);
    }
  }
  return number(row.b, 0);
}

/// Two rows and two speeds: the rows alone determine the accelerations, A u' = b, whatever the forces. Cramer's rule on
/// A itself does not square its condition, so that the guard may be looser than that of LDL^T by `square_leeway`: with
/// det A = |a_1| |a_2| sin(phi), it asks for sin^2(phi) >= 1e-12, and the error is near eps / sin(phi) <= 1e-10.
/// det^2 stands for d_2 S_11, which it equals.
void eliminate_square(const Island& island, const Derivatives& derivatives, const RightSides& right,
                      Elimination& result) {
  constexpr double square_leeway = 1e-8;
  const Row& first = derivatives.rows[island.rows[0]];
  const Row& second = derivatives.rows[island.rows[1]];
  const std::size_t p = island.speeds[0];
  const std::size_t q = island.speeds[1];
  const Expr a = entry_along(first, p);
  const Expr b = entry_along(first, q);
  const Expr c = entry_along(second, p);
  const Expr d = entry_along(second, q);
  const Expr determinant = difference_of({a * d, b * c});
  const Expr reciprocal = number(a, 1) / determinant;
  const Expr mobilities = derivatives.mobility[p] * derivatives.mobility[q];
  const Expr s1 = result.pivots[0].diagonal;
  const Expr s2 = result.pivots[1].diagonal;
  result.pivots[1] = {island.rows[1], number(a, square_leeway) * (s1 * s2), determinant * determinant * mobilities, s1};
  const Expr b1 = right.b[0];
  const Expr b2 = right.b[1];
  result.accelerations = {reciprocal * difference_of({d * b1, b * b2}), reciprocal * difference_of({a * b2, c * b1})};
  const Expr force_p = (result.accelerations[0] - derivatives.free[p]) / derivatives.mobility[p];
  const Expr force_q = (result.accelerations[1] - derivatives.free[q]) / derivatives.mobility[q];
  result.multipliers = {reciprocal * difference_of({d * force_p, c * force_q}),
                        reciprocal * difference_of({a * force_q, b * force_p})};
}

/// The accelerations of the island's speeds from those of its uncoupled ones.
std::vector<Expr> coupled_in(const Island& island, const Derivatives& derivatives, std::vector<Expr> values) {
  std::vector<Coupling> couplings;
  for (const Coupling& coupling : derivatives.couplings) {
    if (std::binary_search(island.speeds.begin(), island.speeds.end(), coupling.speed)) {
      couplings.push_back(coupling);
    }
  }
  if (couplings.empty()) {
    return values;
  }
  std::vector<Expr> by_speed = derivatives.free;
  for (std::size_t j = 0; j < island.speeds.size(); ++j) {
    by_speed[island.speeds[j]] = values[j];
  }
  by_speed = coupled(couplings, std::move(by_speed));
  for (std::size_t j = 0; j < island.speeds.size(); ++j) {
    values[j] = by_speed[island.speeds[j]];
  }
  return values;
}

}  // namespace

bool rows_determine(const Island& island) { return island.rows.size() == 2 && island.speeds.size() == 2; }

Elimination eliminate(const Island& island, const Derivatives& derivatives, graph::Graph& graph) {
  RightSides right;
  for (const std::size_t k : island.rows) {
    const Row& row = derivatives.rows[k];
    right.b.push_back(as_solved(row, row.b));
    right.residual.push_back(as_solved(row, row.residual));
  }
  return eliminate(island, derivatives, right, graph);
}

Elimination eliminate(const Island& island, const Derivatives& derivatives, const RightSides& right,
                      graph::Graph& graph) {
  std::vector<Sparse> columns = assemble(island, derivatives);  // becomes L D, column by column
  const std::size_t size = columns.size();
  Elimination result;
  list_in_model_order(island, derivatives, columns, result);
  for (std::size_t k = 0; k < size; ++k) {
    result.pivots.push_back({island.rows[k], columns[k].at(k), columns[k].at(k), graph.constant(1)});
  }
  result.forward = right.residual;
  result.multipliers.assign(size, graph.constant(0));
  if (rows_determine(island)) {
    eliminate_square(island, derivatives, right, result);
    result.accelerations = coupled_in(island, derivatives, std::move(result.accelerations));
    return result;
  }
  if (size == 2 && columns[0].contains(1)) {
    eliminate_two(columns, result);
  } else {
    eliminate_in_order(columns, result);
  }
  accelerate(island, derivatives, result, graph);
  result.accelerations = coupled_in(island, derivatives, std::move(result.accelerations));
  return result;
}

}  // namespace mbcc::mechanics
