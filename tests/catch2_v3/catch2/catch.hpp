#pragma once
// Catch2 3 under the name of version 2's only header.

#include <catch2/catch_all.hpp>

using Catch::Approx;

namespace Catch::Detail {
using Catch::Approx;
}
