#pragma once
// Storage and convolutions for the Taylor series of a motion. Emitted code computes the coefficients (Note [series] in
// the compiler's program/series_plan.hpp); what all models share is here: rows of operands, a row for each order, and
// the sums of products of their rows.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstring>
#include <utility>

namespace mbrt {

/// The smallest tolerance, the rounding of numbers, asks for 25.
inline constexpr std::size_t largest_order = 30;

namespace lanes {

// Longer vectors would be filled by large scenes alone, and small ones pay for what they leave empty (measured).
#if defined(__AVX__)
inline constexpr std::size_t width = 4;
#else
inline constexpr std::size_t width = 2;
#endif

/// A vector of the machine, which both compilers know how to add and multiply.
using Vector [[gnu::vector_size(width * sizeof(double))]] = double;

/// Vectors summed at once: enough to hide the latency of an addition, few enough for the registers.
inline constexpr std::size_t at_once = 8;
/// Rows are this many doubles or a multiple of it: whole vectors of any machine.
inline constexpr std::size_t granule = 8;

constexpr std::size_t padded(std::size_t count) { return (count + granule - 1) / granule * granule; }
constexpr std::size_t vectors(std::size_t count) { return (count + width - 1) / width; }

[[gnu::always_inline]] inline Vector load(const double* from) {
  Vector vector;
  std::memcpy(&vector, from, sizeof vector);
  return vector;
}
[[gnu::always_inline]] inline void store(const Vector& vector, double* to) { std::memcpy(to, &vector, sizeof vector); }

// Sums run from the middle outwards: rows that were written last have not reached the cache yet, and come last. Two
// sums at a time halve the time that additions wait for one another.

/// sums[V] = sum of left_j right_(m-j) over 1 < j < m - 1, or where m is 2 less that of 0 < j < m, for so many
/// neighbouring vectors.
template <std::size_t Stride, std::size_t... V>
[[gnu::always_inline]] inline void convolve(const double* left, const double* right, std::size_t m, Vector* sums,
                                            std::index_sequence<V...>) {
  Vector upper[sizeof...(V)];
  ((sums[V] = Vector{}), ...);
  ((upper[V] = Vector{}), ...);
  if (m % 2 == 0) {
    const std::size_t middle = m / 2 * Stride;
    ((sums[V] = load(left + middle + V * width) * load(right + middle + V * width)), ...);
    if (m == 2) {
      ((sums[V] = -sums[V]), ...);
    }
  }
  for (std::size_t j = (m - 1) / 2; j > 1; --j) {
    const std::size_t low = j * Stride, high = (m - j) * Stride;
    ((sums[V] += load(left + low + V * width) * load(right + high + V * width)), ...);
    ((upper[V] += load(left + high + V * width) * load(right + low + V * width)), ...);
  }
  ((sums[V] += upper[V]), ...);
}

/// Likewise half the sums of x_j x_(m-j).
template <std::size_t Stride, std::size_t... V>
[[gnu::always_inline]] inline void convolve_square(const double* x, std::size_t m, Vector* sums,
                                                   std::index_sequence<V...>) {
  Vector odd[sizeof...(V)];
  ((sums[V] = Vector{}), ...);
  ((odd[V] = Vector{}), ...);
  std::size_t j = (m - 1) / 2;
  if (j > 1 && j % 2 == 0) {
    ((odd[V] = load(x + j * Stride + V * width) * load(x + (m - j) * Stride + V * width)), ...);
    --j;
  }
  for (; j > 1; j -= 2) {
    ((sums[V] += load(x + j * Stride + V * width) * load(x + (m - j) * Stride + V * width)), ...);
    ((odd[V] += load(x + (j - 1) * Stride + V * width) * load(x + (m - j + 1) * Stride + V * width)), ...);
  }
  ((sums[V] += odd[V]), ...);
  if (m % 2 == 0) {
    const std::size_t middle = m / 2 * Stride;
    const double weight = m == 2 ? -0.5 : 0.5;
    ((sums[V] += weight * (load(x + middle + V * width) * load(x + middle + V * width))), ...);
  }
}

}  // namespace lanes

/// Operands of so many lanes, by order.
template <std::size_t Lanes>
using Rows = std::array<std::array<double, lanes::padded(Lanes)>, largest_order + 3>;

/// Calls `chunk(first lane, number of vectors as a type)` for all lanes, at most lanes::at_once vectors at a time.
template <std::size_t Lanes, class Chunk>
[[gnu::always_inline]] inline void by_chunks(const Chunk& chunk) {
  constexpr std::size_t total = lanes::vectors(Lanes), full = total / lanes::at_once * lanes::at_once;
  for (std::size_t v = 0; v < full; v += lanes::at_once) {
    chunk(v * lanes::width, std::make_index_sequence<lanes::at_once>{});
  }
  if constexpr (full < total) {
    chunk(full * lanes::width, std::make_index_sequence<total - full>{});
  }
}

/// sums[i] = sum of left_j[i] right_(m-j)[i] over 1 < j < m - 1: the terms with the newest operands are left out. Where
/// m is 2 these are one, and the sum is its negative, so that it may be added twice.
template <std::size_t Lanes>
void sum_products(const Rows<Lanes>& left, const Rows<Lanes>& right, std::size_t m, double* sums) {
  by_chunks<Lanes>([&]<std::size_t... V>(std::size_t first, std::index_sequence<V...> vectors) {
    lanes::Vector chunk[sizeof...(V)];
    lanes::convolve<lanes::padded(Lanes)>(left[0].data() + first, right[0].data() + first, m, chunk, vectors);
    (lanes::store(chunk[V], sums + first + V * lanes::width), ...);
  });
}

/// Likewise half the sums of x_j[i] x_(m-j)[i], with half the multiplications.
template <std::size_t Lanes>
void sum_squares(const Rows<Lanes>& x, std::size_t m, double* sums) {
  by_chunks<Lanes>([&]<std::size_t... V>(std::size_t first, std::index_sequence<V...> vectors) {
    lanes::Vector chunk[sizeof...(V)];
    lanes::convolve_square<lanes::padded(Lanes)>(x[0].data() + first, m, chunk, vectors);
    (lanes::store(chunk[V], sums + first + V * lanes::width), ...);
  });
}

/// Where the coefficients of several quantities are: a row for each order, padded to whole vectors.
struct CoefficientRows {
  const double* first = nullptr;
  std::size_t stride = 0;
  std::size_t count = 0;  ///< quantities

  const double* row(std::size_t order) const { return first + order * stride; }
};

/// The series of a motion up to some order, and up to one less those of the arguments of its switches: a series holds
/// as long as none of these changes its sign.
struct Coefficients {
  CoefficientRows state;
  CoefficientRows switches;
};

/// The coefficients of the motion of a model with `Coordinates` and `Speeds`, and the lanes that they take.
template <std::size_t Coordinates, std::size_t Speeds, std::size_t Products, std::size_t SlowProducts,
          std::size_t Squares, std::size_t SlowSquares, std::size_t Switches>
struct Series {
  static constexpr std::size_t size = Coordinates + Speeds;

  /// y(t + h) = sum of state[k] h^k. Coordinates are known to one order more than was asked for.
  alignas(64) Rows<size> state{};
  alignas(64) Rows<Switches> switches{};
  std::array<double, Speeds> free{};  ///< accelerations without constraints, at the order of the pass

  alignas(64) Rows<Products> left{};
  alignas(64) Rows<Products> right{};
  alignas(64) Rows<SlowProducts> slow_left{};
  alignas(64) Rows<SlowProducts> slow_right{};
  alignas(64) Rows<Squares> squares{};
  alignas(64) Rows<SlowSquares> slow_squares{};
  alignas(64) std::array<double, lanes::padded(Products)> product_sums{};
  alignas(64) std::array<double, lanes::padded(SlowProducts)> slow_product_sums{};
  alignas(64) std::array<double, lanes::padded(Squares)> square_sums{};
  alignas(64) std::array<double, lanes::padded(SlowSquares)> slow_square_sums{};

  Coefficients coefficients() const {
    return {{state[0].data(), lanes::padded(size), size}, {switches[0].data(), lanes::padded(Switches), Switches}};
  }

  /// Clears what the first pass reads before it is computed: sums of order 1, which are empty, and operands of order 1
  /// that an earlier series has left.
  void begin() {
    product_sums.fill(0);
    slow_product_sums.fill(0);
    square_sums.fill(0);
    slow_square_sums.fill(0);
    left[1].fill(0);
    slow_left[1].fill(0);
    slow_right[1].fill(0);
    squares[1].fill(0);
    slow_squares[1].fill(0);
  }

  /// The sums of order m of fast lanes, and of order m - 1 of slow ones.
  void sum(std::size_t m) {
    if constexpr (Products > 0) {
      sum_products<Products>(left, right, m, product_sums.data());
    }
    if constexpr (SlowProducts > 0) {
      sum_products<SlowProducts>(slow_left, slow_right, m - 1, slow_product_sums.data());
    }
    if constexpr (Squares > 0) {
      sum_squares<Squares>(squares, m, square_sums.data());
    }
    if constexpr (SlowSquares > 0) {
      sum_squares<SlowSquares>(slow_squares, m - 1, slow_square_sums.data());
    }
  }
};

/// A model with emitted recurrences: `expand` computes the coefficients of the motion through a state at the time set,
/// up to an order between 1 and largest_order. False where there is no series, or none that is to be trusted: the plain
/// solve of the constraints is not safe.
template <class M>
concept HasSeries = requires(M& model, const typename M::State& state, typename M::Series& series) {
  { model.expand(state, std::size_t{1}, series) } -> std::same_as<bool>;
};

/// k and 1 / k as numbers, for the orders that a pass meets.
inline constexpr auto order_numbers = [] {
  std::array<double, largest_order + 3> numbers{};
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    numbers[k] = static_cast<double>(k);
  }
  return numbers;
}();
inline constexpr auto inverse_orders = [] {
  std::array<double, largest_order + 3> inverses{};
  for (std::size_t k = 1; k < inverses.size(); ++k) {
    inverses[k] = 1 / static_cast<double>(k);
  }
  return inverses;
}();

}  // namespace mbrt
