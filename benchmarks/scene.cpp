#include "scene.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace bench {

namespace {

/// What differs from one chain to the next. `end` is the position of the last mass, computed by extrapolation in
/// 113-bit arithmetic at two tolerances that agree to the digits given.
struct ChainData {
  std::size_t links;
  double push;  ///< also in models/, which CMakeLists.txt generates
  double step;
  long steps;
  std::array<double, 3> end;
  double error_bound;
};

constexpr std::array chains{
    ChainData{3, 1, 0.001, 3000, {2.1966081193683676361, 0.54394912265622527156, -1.8997075659265217624}, 4e-10},
    ChainData{10, 1, 0.001, 3000, {-7.5371994054581428276, -2.5705531392991955574, -5.9339615537163370821}, 1.2e-9},
    ChainData{100, 0.1, 0.002, 500, {77.298515013543228712, 2.9643450750627420156, -62.878886260157411819}, 2e-10},
    ChainData{200, 0.1, 0.002, 500, {157.35084612302407656, 5.9655310445164396848, -122.91813459226803793}, 2e-10},
};

}  // namespace

Scene paper_example() {
  using std::numbers::pi;
  using std::numbers::sqrt2;
  // z1 = (sqrt2/2) cn/dn of 2 pi t with m = 1/2, and the meridian has turned five times.
  constexpr double z1 = 0.07287998710974598;
  return {"artigo5", {sqrt2 / 2, 0, sqrt2 / 2, 2, 1, -0.75, 0, sqrt2 * pi, 0, 0, 0, 0.25},     0.005,
          1000,      {{0, std::sqrt(1 - z1 * z1)}, {1, 0}, {2, z1}, {3, 2}, {4, 1}, {5, 0.5}}, 2.3e-5};
}

Scene chain(std::size_t links) {
  for (const ChainData& data : chains) {
    if (data.links != links) {
      continue;
    }
    Scene scene{"chain_" + std::to_string(links), {}, data.step, data.steps, {}, data.error_bound};
    scene.start.resize(6 * links);
    for (std::size_t i = 0; i < links; ++i) {
      const auto number = static_cast<double>(i + 1);
      scene.start[3 * i] = 0.8 * number;
      scene.start[3 * i + 2] = -0.6 * number;
      scene.start[3 * (links + i) + 1] = 0.3 * number * data.push;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.end.push_back({3 * (links - 1) + axis, data.end[axis]});
    }
    return scene;
  }
  throw std::invalid_argument("no reference for a chain of " + std::to_string(links) + " links");
}

}  // namespace bench
