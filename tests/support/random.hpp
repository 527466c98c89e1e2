#pragma once
// Random choices that are the same on every machine; the standard's distributions are not.

#include <cstddef>
#include <cstdint>
#include <random>

namespace mbcc::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [low, high).
  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) * 0x1p-53);
  }
  /// In 0 .. count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  template <class Range>
  const auto& pick(const Range& range) {
    return range[below(range.size())];
  }
  template <class Range>
  void shuffle(Range& range) {
    for (std::size_t i = range.size(); i > 1; --i) {
      std::swap(range[i - 1], range[below(i)]);
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace mbcc::test
