#include "mbrt/math.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace mbrt;

TEST_CASE("sign is -1, 0 or 1") {
  static_assert(sign(-2.5) == -1 && sign(0.0) == 0 && sign(-0.0) == 0 && sign(1e-300) == 1);
  CHECK(std::isnan(sign(std::nan(""))));
}

TEST_CASE("min and max choose an operand") {
  static_assert(min(1, 2) == 1 && min(2, 1) == 1 && max(1, 2) == 2 && max(2, 1) == 2);
}

TEST_CASE("min and max pass a NaN on from either side") {
  CHECK(std::isnan(min(std::nan(""), 1)));
  CHECK(std::isnan(min(1, std::nan(""))));
  CHECK(std::isnan(max(std::nan(""), 1)));
  CHECK(std::isnan(max(1, std::nan(""))));
}

TEST_CASE("sincos is the pair that sin and cos give") {
  for (const double angle : {0.0, 1e-9, 0.7, -2.5, 100.0, 1e6}) {
    const auto [s, c] = sincos(angle);
    // Each is correct to an ulp of its own, whatever the library does.
    CHECK(s == Approx(std::sin(angle)).epsilon(4e-16));
    CHECK(c == Approx(std::cos(angle)).epsilon(4e-16));
  }
}

TEST_CASE("all_finite sees infinities and NaN") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(all_finite(std::array<double, 0>{}));
  CHECK(all_finite(std::array{1.0, 1e308}));
  CHECK_FALSE(all_finite(std::array{1.0, -infinity}));
  CHECK_FALSE(all_finite(std::array{std::nan(""), 1.0}));
}
