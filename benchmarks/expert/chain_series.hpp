#pragma once
// The chain of unit masses on unit rods by its Taylor series, by hand: what someone who knows the model, the method and
// the machine writes. One vector holds x, y, z of a mass, so that everything but the tensions is arithmetic of vectors,
// and sums over axes are within one. The recurrences are those that mbcc emits, with nothing around them: no test of
// pivots, no switches, no fallback, no compensation of rounding. The last mass may be held where it is, which makes a
// pendulum, a chain, a four-bar and a ring one program.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bench::expert {

template <std::size_t Links, bool IsHeld = false>
class ChainSeries {
 public:
  /// Integrates from 0 to `to`; positions of all masses, then velocities, three numbers each.
  std::vector<double> integrate(std::vector<double> state, double to, double tolerance) {
    order_ = static_cast<std::size_t>(std::ceil(1 - 0.65 * std::log(tolerance)));
    take_scales(state);
    for (std::size_t i = 0; i < Links; ++i) {
      r_[0][i] = vector_at(state, i);
      v_[0][i] = vector_at(state, Links + i);
    }
    for (double t = 0; t < to;) {
      expand();
      const double rest = to - t;
      const double step = length(tolerance);
      const double h = step >= 0.99 * rest ? rest : step > 0.5 * rest ? 0.5 * rest : step;
      t = h == rest ? to : t + h;
      advance(h);
    }
    for (std::size_t i = 0; i < 3 * Links; ++i) {
      state[i] = r_[0][i / 3][i % 3];
      state[3 * Links + i] = v_[0][i / 3][i % 3];
    }
    return state;
  }

 private:
  using Vector [[gnu::vector_size(32)]] = double;
  struct Row {
    Vector of[Links];
    Vector& operator[](std::size_t i) { return of[i]; }
    const Vector& operator[](std::size_t i) const { return of[i]; }
  };
  static constexpr std::size_t most_orders = 32;

  static Vector vector_at(const std::vector<double>& state, std::size_t i) {
    return Vector{state[3 * i], state[3 * i + 1], state[3 * i + 2], 0};
  }
  static constexpr bool is_held(std::size_t i) { return IsHeld && i + 1 == Links; }
  static double sum(Vector a) { return a[0] + a[1] + a[2]; }
  static double dot(Vector a, Vector b) { return sum(a * b); }

  void rods(std::size_t k) {
    d_[k][0] = r_[k][0];
    for (std::size_t i = 1; i < Links; ++i) {
      d_[k][i] = r_[k][i] - r_[k][i - 1];
    }
  }

  /// The tridiagonal matrix of the tensions, eliminated from the first link on.
  void factorise() {
    for (std::size_t i = 0; i < Links; ++i) {
      const double moving_ends = i == 0 || is_held(i) ? 1 : 2;
      double pivot = moving_ends * dot(d_[0][i], d_[0][i]);
      if (i > 0) {
        const double coupling = -dot(d_[0][i - 1], d_[0][i]);
        multiplier_[i] = coupling * inverse_pivot_[i - 1];
        pivot -= multiplier_[i] * coupling;
      }
      inverse_pivot_[i] = 1 / pivot;
    }
  }

  void expand() {
    rods(0);
    factorise();
    for (std::size_t i = 0; i < Links; ++i) {
      r_[1][i] = v_[0][i];
    }
    for (std::size_t k = 0; k < order_; ++k) {
      rods(k + 1);
      const std::size_t m = k + 2;
      Vector squares[Links], reactions[Links];
      for (std::size_t i = 0; i < Links; ++i) {
        squares[i] = m % 2 == 0 ? 0.5 * d_[m / 2][i] * d_[m / 2][i] : Vector{};
        reactions[i] = Vector{};
      }
      for (std::size_t j = (m - 1) / 2; j > 0; --j) {
        for (std::size_t i = 0; i < Links; ++i) {
          squares[i] += d_[j][i] * d_[m - j][i];
        }
      }
      for (std::size_t j = 0; j < k; ++j) {
        for (std::size_t i = 0; i < Links; ++i) {
          reactions[i] += tension_[j][i] * d_[k - j][i];
        }
      }
      solve(k, squares, reactions);
    }
  }

  void solve(std::size_t k, const Vector* squares, const Vector* reactions) {
    const double first = static_cast<double>(k + 1), second = static_cast<double>(k + 2);
    const Vector gravity = {0, 0, k == 0 ? -9.81 : 0, 0};
    Vector known[Links];
    double right[Links];
    for (std::size_t i = 0; i < Links; ++i) {
      known[i] = reactions[i] + gravity;
      if (i + 1 < Links) {
        known[i] -= reactions[i + 1];
      }
      if (is_held(i)) {
        known[i] = Vector{};
      }
      const Vector along = i == 0 ? known[i] : known[i] - known[i - 1];
      right[i] = -sum(first * second * squares[i] + d_[0][i] * along);
      if (i > 0) {
        right[i] -= multiplier_[i] * right[i - 1];
      }
    }
    for (std::size_t i = Links; i-- > 0;) {
      tension_[k][i] = right[i] * inverse_pivot_[i];
      if (i + 1 < Links) {
        tension_[k][i] -= multiplier_[i + 1] * tension_[k][i + 1];
      }
    }
    for (std::size_t i = 0; i < (IsHeld ? Links - 1 : Links); ++i) {
      Vector acceleration = known[i] + tension_[k][i] * d_[0][i];
      if (i + 1 < Links) {
        acceleration -= tension_[k][i + 1] * d_[0][i + 1];
      }
      v_[k + 1][i] = acceleration * inverse_[k + 1];
      r_[k + 2][i] = v_[k + 1][i] * inverse_[k + 2];
    }
  }

  /// The step at which the last two terms are as large as is allowed.
  double length(double tolerance) const {
    double shortest = 0;
    for (const std::size_t k : {order_ - 1, order_}) {
      double largest = 0;
      for (std::size_t i = 0; i < Links; ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          largest = std::max(largest, std::abs(r_[k][i][axis]) / (length_scale_ + std::abs(r_[0][i][axis])));
          largest = std::max(largest, std::abs(v_[k][i][axis]) / (speed_scale_ + std::abs(v_[0][i][axis])));
        }
      }
      shortest = std::max(shortest, std::log2(largest / tolerance) / static_cast<double>(k));
    }
    return std::exp2(-shortest);
  }

  void advance(double h) {
    for (std::size_t i = 0; i < Links; ++i) {
      Vector r = r_[order_][i], v = v_[order_][i];
      for (std::size_t k = order_; k-- > 0;) {
        r = r * h + r_[k][i];
        v = v * h + v_[k][i];
      }
      r_[0][i] = r;
      v_[0][i] = v;
    }
  }

  /// The largest coordinate of the start, and the speed that gravity gives over it.
  void take_scales(const std::vector<double>& state) {
    length_scale_ = 0;
    for (std::size_t j = 0; j < 3 * Links; ++j) {
      length_scale_ = std::max(length_scale_, std::abs(state[j]));
    }
    speed_scale_ = std::sqrt(9.81 * length_scale_);
  }

  std::size_t order_ = 0;
  double length_scale_ = 1, speed_scale_ = 1;
  std::array<Row, most_orders> r_{}, v_{}, d_{};
  std::array<std::array<double, Links>, most_orders> tension_{};
  std::array<double, Links> multiplier_{}, inverse_pivot_{};
  const std::array<double, most_orders> inverse_ = [] {
    std::array<double, most_orders> inverses{};
    for (std::size_t k = 1; k < most_orders; ++k) {
      inverses[k] = 1 / static_cast<double>(k);
    }
    return inverses;
  }();
};

}  // namespace bench::expert
