#pragma once
// Embedded Runge-Kutta pairs of order 8 for q'' = a(t, q, v) from 0, as the textbook has them (Hairer, Norsett, Wanner,
// Solving Ordinary Differential Equations I, section II.4): sums written out when compiling, terms that are zero left
// out, the right-hand side inlined. Nothing else: no events, no dense output, no projection, no words for failures.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "expert/second_order_rk4.hpp"

namespace bench::expert {

/// A Pair has `stages`, `node(s)`, `Stage<s>` with the weights of stage s (that of `stages` is the step's end), the
/// weights of each of its `Estimates`, and `error(h, norms of the estimates)`.
template <class Pair, std::size_t Size, class Model>
class EmbeddedPair {
 public:
  EmbeddedPair(Model model, const Motion<Size>& start, double tolerance)
      : model_(std::move(model)), y_(start), tolerance_(tolerance) {}

  Motion<Size> integrate(double to) {
    evaluate(0, y_, k_[0]);
    double h = std::min(first_step(), to);
    bool shrunk = false;
    int attempts = 0;
    for (double t = 0; t < to && attempts < most_attempts; ++attempts) {
      const bool is_last = t + 1.01 * h >= to;
      h = is_last ? to - t : h;
      const double error = attempt(t, h);
      const double wish = 0.9 * std::pow(error, -1.0 / 8);
      const double factor = wish > 1.0 / 3 ? std::min(wish, shrunk ? 1.0 : 6.0) : 1.0 / 3;
      shrunk = !(error <= 1);
      if (!shrunk) {
        t = is_last ? to : t + h;
        y_ = stage_;
        evaluate(t, y_, k_[0]);
      }
      h *= factor;
    }
    return y_;
  }

 private:
  static constexpr std::size_t stages = Pair::stages;
  static constexpr int most_attempts = 100000;  // as in the textbook's codes: then it gives up, wherever it is

  void evaluate(double t, const Motion<Size>& y, Motion<Size>& k) {
    model_.set_time(t);
    model_.acceleration(y, k.v);
    k.q = y.v;
  }

  template <class Weights, std::size_t... I>
  [[gnu::always_inline]] double sum(const Vector<Size> Motion<Size>::*part, std::size_t j,
                                    std::index_sequence<I...>) const {
    double total = 0;
    (
        [&] {
          if constexpr (Weights::at(I) != 0) {
            total += Weights::at(I) * (k_[I].*part)[j];
          }
        }(),
        ...);
    return total;
  }
  template <class Weights>
  [[gnu::always_inline]] double sum(const Vector<Size> Motion<Size>::*part, std::size_t j) const {
    return sum<Weights>(part, j, std::make_index_sequence<Weights::count>{});
  }

  template <std::size_t Stage>
  [[gnu::always_inline]] void advance(double h) {
    using Weights = typename Pair::template Stage<Stage>;
    for (std::size_t j = 0; j < Size; ++j) {
      stage_.q[j] = y_.q[j] + h * sum<Weights>(&Motion<Size>::q, j);
      stage_.v[j] = y_.v[j] + h * sum<Weights>(&Motion<Size>::v, j);
    }
  }

  double attempt(double t, double h) {
    [&]<std::size_t... S>(std::index_sequence<S...>) {
      ((advance<S + 1>(h), evaluate(t + Pair::node(S + 1) * h, stage_, k_[S + 1])), ...);
    }
    (std::make_index_sequence<stages - 1>{});
    advance<stages>(h);
    return [&]<class... Estimate>(std::type_identity<std::tuple<Estimate...>>) {
      return Pair::error(h, norm<Estimate>()...);
    }(std::type_identity<typename Pair::Estimates>{});
  }

  /// The root of the mean square of a sum over stages, in parts of what the tolerance allows.
  template <class Weights>
  double norm() const {
    double squares = 0;
    const auto add = [&](const Vector<Size> Motion<Size>::*part, std::size_t j) {
      const double size = 1 + std::max(std::abs((y_.*part)[j]), std::abs((stage_.*part)[j]));
      const double error = sum<Weights>(part, j) / (tolerance_ * size);
      squares += error * error;
    };
    for (std::size_t j = 0; j < Size; ++j) {
      add(&Motion<Size>::q, j);
      add(&Motion<Size>::v, j);
    }
    return std::sqrt(squares / (2 * Size));
  }

  double first_step() const {
    double state = 0, rate = 0;
    for (std::size_t j = 0; j < Size; ++j) {
      state = std::max({state, std::abs(y_.q[j]), std::abs(y_.v[j])});
      rate = std::max({rate, std::abs(k_[0].q[j]), std::abs(k_[0].v[j])});
    }
    return 0.5 * state / rate * std::pow(tolerance_, 1.0 / 8);
  }

  Model model_;
  Motion<Size> y_, stage_;
  std::array<Motion<Size>, stages> k_;
  double tolerance_;
};

}  // namespace bench::expert
