#include "mechanics/uncouple.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "mechanics/collect.hpp"

namespace mbcc::mechanics {

namespace {

using BySpeed = std::map<std::size_t, Expr>;

void subtract(BySpeed& values, std::size_t speed, Expr term) {
  const auto [found, is_new] = values.try_emplace(speed, -term);
  if (!is_new) {
    found->second = found->second - term;
  }
}

class Uncoupling {
 public:
  Uncoupling(const InertiaMatrix& inertia, std::vector<Expr> forces, const std::vector<Row>& rows, const Point& start)
      : matrix_(inertia), forces_(std::move(forces)), model_rows_(rows), start_(start), taken_(rows.size()) {
    for (std::size_t j = 0; j < matrix_.size(); ++j) {
      for (const auto& [i, value] : inertia[j]) {
        matrix_[i].try_emplace(j, value);  // the symmetric entry may have been folded to zero
      }
    }
    for (const Row& row : rows) {
      BySpeed& entries = rows_.emplace_back();
      for (const Entry& entry : row.entries) {
        entries.emplace(entry.speed, entry.value);
      }
    }
    result_.inertia.resize(matrix_.size());
    result_.free.resize(matrix_.size());
  }

  Uncoupled run() {
    std::set<std::size_t> open;
    for (std::size_t j = 0; j < matrix_.size(); ++j) {
      if (matrix_[j].empty()) {
        eliminate_massless(j);
      } else {
        open.insert(j);
      }
    }
    for (std::size_t j = 0; j < matrix_.size(); ++j) {
      if (!open.contains(j)) {
        result_.free[j] = result_.free[j] + forces_[j];
      }
    }
    while (!open.empty()) {
      const std::size_t next = *std::min_element(open.begin(), open.end(), [this](std::size_t a, std::size_t b) {
        return std::tuple(matrix_[a].size(), a) < std::tuple(matrix_[b].size(), b);
      });
      open.erase(next);
      eliminate(next);
    }
    for (const BySpeed& row : rows_) {
      std::vector<Entry>& entries = result_.rows.emplace_back();
      for (const auto& [speed, value] : row) {
        if (!is_zero(value)) {
          entries.push_back({speed, value});
        }
      }
    }
    return std::move(result_);
  }

 private:
  /// A step of L D L^T: the speeds that share inertia with `j` lose it.
  void eliminate(std::size_t j) {
    const Expr pivot = matrix_[j].at(j);
    Coupling coupling{j, {}};
    for (const auto& [i, entry] : matrix_[j]) {
      if (i != j) {
        coupling.terms.push_back({i, entry / pivot});
      }
    }
    for (const Entry& term : coupling.terms) {
      matrix_[term.speed].erase(j);
      for (const auto& [i, entry] : matrix_[j]) {
        if (i != j) {
          subtract(matrix_[term.speed], i,
                   std::max(i, term.speed) == i ? term.value * entry : ratio(coupling, i) * matrix_[j].at(term.speed));
        }
      }
    }
    result_.inertia[j] = pivot;
    result_.free[j] = forces_[j] / pivot;
    apply(coupling);
  }

  /// L_ij, so that both halves of the matrix get the same expression.
  static Expr ratio(const Coupling& coupling, std::size_t i) {
    return std::find_if(coupling.terms.begin(), coupling.terms.end(),
                        [i](const Entry& term) { return term.speed == i; })
        ->value;
  }

  void eliminate_massless(std::size_t s) {
    const std::optional<std::size_t> row = defining_row(s);
    result_.inertia[s] = number(forces_[s], 1);
    result_.free[s] = number(forces_[s], 0);
    if (!row) {
      result_.undetermined.push_back(s);
      return;
    }
    taken_[*row] = true;
    const Expr own = rows_[*row].at(s);
    Coupling coupling{s, {}};
    for (const auto& [i, entry] : rows_[*row]) {
      if (i != s) {
        coupling.terms.push_back({i, entry / own});
      }
    }
    result_.free[s] = model_rows_[*row].b / own;
    apply(coupling);
    rows_[*row] = {{s, own}};  // all else is exactly zero now
  }

  /// The row that is best to divide by: a constant entry before one that is not zero at the start.
  std::optional<std::size_t> defining_row(std::size_t s) const {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const auto entry = rows_[k].find(s);
      if (taken_[k] || entry == rows_[k].end() || is_zero(entry->second)) {
        continue;
      }
      if (entry->second.is_constant()) {
        return k;
      }
      const double value = value_at(start_, entry->second);
      if (!best && std::isfinite(value) && value != 0) {
        best = k;
      }
    }
    return best;
  }

  /// Rows and forces in the new speeds.
  void apply(const Coupling& coupling) {
    for (BySpeed& row : rows_) {
      if (const auto own = row.find(coupling.speed); own != row.end()) {
        const Expr value = own->second;
        for (const Entry& term : coupling.terms) {
          subtract(row, term.speed, value * term.value);
        }
      }
    }
    for (const Entry& term : coupling.terms) {
      forces_[term.speed] = forces_[term.speed] - term.value * forces_[coupling.speed];
    }
    if (!coupling.terms.empty()) {
      result_.couplings.push_back(coupling);
    }
  }

  InertiaMatrix matrix_;  ///< of what has not been eliminated
  std::vector<Expr> forces_;
  const std::vector<Row>& model_rows_;
  const Point& start_;
  std::vector<bool> taken_;  ///< rows that determine a speed
  std::vector<BySpeed> rows_;
  Uncoupled result_;
};

}  // namespace

Uncoupled uncouple(const InertiaMatrix& inertia, std::vector<Expr> forces, const std::vector<Row>& rows,
                   const Point& start) {
  return Uncoupling(inertia, std::move(forces), rows, start).run();
}

std::vector<Expr> coupled(const std::vector<Coupling>& couplings, std::vector<Expr> values) {
  for (auto coupling = couplings.rbegin(); coupling != couplings.rend(); ++coupling) {
    for (const Entry& term : coupling->terms) {
      values[coupling->speed] = values[coupling->speed] - term.value * values[term.speed];
    }
  }
  return values;
}

std::vector<Expr> uncoupled(const std::vector<Coupling>& couplings, std::vector<Expr> values) {
  for (const Coupling& coupling : couplings) {
    for (const Entry& term : coupling.terms) {
      values[coupling.speed] = values[coupling.speed] + term.value * values[term.speed];
    }
  }
  return values;
}

}  // namespace mbcc::mechanics
