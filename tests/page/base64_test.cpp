#include "page/base64.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using mbcc::page::base64;

// Expected texts: coreutils' base64 of the numbers as IEEE 754 binary64, little-endian.
TEST_CASE("numbers are written as their bytes") {
  CHECK(base64({}) == "");
  CHECK(base64(std::vector{1.0}) == "AAAAAAAA8D8=");
  CHECK(base64(std::vector{1.0, -0.1}) == "AAAAAAAA8D+amZmZmZm5vw==");
  CHECK(base64(std::vector{1.0, -0.1, std::nextafter(2.0, 3.0)}) == "AAAAAAAA8D+amZmZmZm5vwEAAAAAAABA");
}
