#pragma once
// The scenes that the runtime is tested with. Each states what it must do.

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

#include "sample_model.hpp"

namespace mbrt::test {

inline constexpr std::array<const char*, 6> position_names = {"x1", "y1", "z1", "x2", "y2", "z2"};
inline constexpr std::array<const char*, 6> speed_names = {"vx1", "vy1", "vz1", "vx2", "vy2", "vz2"};
inline constexpr std::array<const char*, 6> acceleration_names = {"ax1", "ay1", "az1", "ax2", "ay2", "az2"};
inline constexpr std::array<int, 6> indices = {0, 1, 2, 3, 4, 5};
inline constexpr std::array<ForceEntry, 2> force_entries = {
    {{"force on particle 1, x", "scene.mbd:3"}, {"force on particle 1, y", "scene.mbd:4"}}};

/// The first `size` names of coordinates, and tables that differ from scene to scene.
inline Description describe(const char* name, std::size_t size, std::span<const ConstraintEntry> constraints,
                            std::span<const IslandEntry> islands, Defaults defaults) {
  const auto first = [size](std::span<const char* const> names) { return names.first(size); };
  return {name,
          "0.1.0",
          first(position_names),
          first(speed_names),
          first(acceleration_names),
          {},
          {},
          constraints,
          {},
          islands,
          false,
          false,
          defaults};
}

/// What most scenes do not have.
struct PlainScene {
  std::array<double, 0> parameters;
  void prepare() {}
  template <class State>
  double energy(const State&) const {
    return 0;
  }
  template <class State>
  void outputs(double, const State&, const State&, std::span<double>) const {}
};

/// A particle on a string of length 1 in the plane, hanging down y; lifted to the horizontal. Parameters g and L.
/// Energy is kept, the angle is an output.
struct Pendulum {
  static constexpr std::size_t size = 2, constraints = 1;
  std::array<double, 2> parameters = {9.81, 1};
  double square = 1;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 1> rod = {{{"rod", "pendulum.mbd:7", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(1), std::span(indices).first(2)}}};
    static constexpr std::array<const char*, 1> outputs = {"angle"};
    static constexpr std::array<ParameterEntry, 2> parameters = {{{"gravity", 9.81}, {"length", 1}}};
    static const Description result = [] {
      Description d = describe("pendulum", size, rod, island, {0, 2, 0.01, not_given, not_given, "rk4"});
      d.outputs = outputs;
      d.parameters = parameters;
      d.has_energy = true;
      return d;
    }();
    return result;
  }

  static std::array<double, 4> start() { return {1, 0, 0, 0}; }
  void prepare() { square = parameters[1] * parameters[1]; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {0, -parameters[0]};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State& y) const {
    return {y[0] * y[0] + y[1] * y[1] - square,
            2 * (y[0] * y[2] + y[1] * y[3]),
            {2 * y[0], 2 * y[1]},
            -2 * (y[2] * y[2] + y[3] * y[3])};
  }
  template <class State>
  double energy(const State& y) const {
    return 0.5 * (y[2] * y[2] + y[3] * y[3]) + parameters[0] * y[1];
  }
  template <class State>
  void outputs(double, const State& y, const State&, std::span<double> values) const {
    values[0] = std::atan2(y[1], y[0]);
  }
};

/// The paper's example: a particle on a sphere and a turning meridian; another one under z vx = vy and z^2 vx = vy,
/// whose rows become parallel where z = 0 (t = 3), and which moves on a straight line.
struct Paper {
  static constexpr std::size_t size = 6, constraints = 4;
  std::array<double, 0> parameters;
  void prepare() {}

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 4> entries = {{{"sphere", "artigo5.mbd:16", true},
                                                                {"meridian", "artigo5.mbd:17", true},
                                                                {"constraint_3", "artigo5.mbd:18", false},
                                                                {"constraint_4", "artigo5.mbd:19", false}}};
    static constexpr std::array<IslandEntry, 2> islands = {
        {{std::span(indices).first(2), std::span(indices).first(3)},
         {std::span(indices).subspan(2, 2), std::span(indices).subspan(3, 3)}}};
    static const Description result =
        describe("artigo5", size, entries, islands, {0, 5, 0.005, not_given, not_given, "rk4"});
    return result;
  }

  static std::array<double, 12> start() {
    const double half = std::numbers::sqrt2 / 2;
    return {half, 0, half, 2, 1, -0.75, 0, std::numbers::sqrt2 * std::numbers::pi, 0, 0, 0, 0.25};
  }
  template <class State>
  void free(double, const State& y, std::array<double, size>& a) const {
    a = {-9.81 * y[0], -9.81 * y[1], -9.81 * y[2], 0, 0, 0};
  }
  template <class State>
  ConstraintValue<size> constraint(int k, double t, const State& y) const {
    const double x = y[0], x_ = y[6], yy = y[1], y_ = y[7], z = y[2], z_ = y[8];
    const double omega = 2 * std::numbers::pi;
    const double s = std::sin(omega * t), c = std::cos(omega * t);
    const double z2 = y[5], vx2 = y[9], vy2 = y[10], vz2 = y[11];
    switch (k) {
      case 0:
        return {x * x + yy * yy + z * z - 1,
                2 * (x * x_ + yy * y_ + z * z_),
                {2 * x, 2 * yy, 2 * z},
                -2 * (x_ * x_ + y_ * y_ + z_ * z_)};
      case 1:
        return {x * s - yy * c,
                x_ * s - y_ * c + omega * (x * c + yy * s),
                {s, -c},
                -2 * omega * (x_ * c + y_ * s) + omega * omega * (x * s - yy * c)};
      case 2:
        return {0, z2 * vx2 - vy2, {0, 0, 0, z2, -1, 0}, -vz2 * vx2};
      default:
        return {0, z2 * z2 * vx2 - vy2, {0, 0, 0, z2 * z2, -1, 0}, -2 * z2 * vz2 * vx2};
    }
  }
  template <class State>
  double energy(const State&) const {
    return 0;
  }
  template <class State>
  void outputs(double, const State&, const State&, std::span<double>) const {}
};

/// Thrown up at 3 with gravity 2: y = 3 t - t^2, which RK4 and cubic interpolation reproduce but for rounding.
struct Throw : PlainScene {
  static constexpr std::size_t size = 2, constraints = 0;

  static const Description& description() {
    static const Description result = [] {
      Description d = describe("throw", size, {}, {}, {});
      d.has_energy = true;
      return d;
    }();
    return result;
  }

  static std::array<double, 4> start() { return {0, 0, 1, 3}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {0, -2};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State&) const {
    return {};
  }
  template <class State>
  double energy(const State& y) const {
    return 0.5 * (y[2] * y[2] + y[3] * y[3]) + 2 * y[1];
  }
};

/// x = t until the force along y, sqrt(1 - x), is no number: just after t = 1.
struct Edge : PlainScene {
  static constexpr std::size_t size = 2, constraints = 0;

  static const Description& description() {
    static const Description result = [] {
      Description d = describe("edge", size, {}, {}, {0, 2, 0.3, not_given, not_given, nullptr});
      d.forces = force_entries;
      return d;
    }();
    return result;
  }

  static std::array<double, 4> start() { return {0, 0, 1, 0}; }
  template <class State>
  void free(double, const State& y, std::array<double, size>& a) const {
    a = {0, std::sqrt(1 - y[0])};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State&) const {
    return {};
  }
};

/// x = t, and y = 1/(1 - t) by the force 2/(1 - x)^3: beyond every bound before t = 1.
struct Pole : PlainScene {
  static constexpr std::size_t size = 2, constraints = 0;

  static const Description& description() {
    static const Description result = describe("pole", size, {}, {}, {0, 2, not_given, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 4> start() { return {0, 1, 1, 1}; }
  template <class State>
  void free(double, const State& y, std::array<double, size>& a) const {
    const double gap = 1 - y[0];
    a = {0, 2 / (gap * gap * gap)};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State&) const {
    return {};
  }
};

/// The edge through a constraint: y = sqrt(1 - x) has no derivatives from x = 1 on.
struct Cliff : PlainScene {
  static constexpr std::size_t size = 2, constraints = 1;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 1> entry = {{{"cliff", "cliff.mbd:5", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(1), std::span(indices).first(2)}}};
    static const Description result =
        describe("cliff", size, entry, island, {0, 2, 0.01, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 4> start() { return {0, 1, 1, -0.5}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {1, 0};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State& y) const {
    const double root = std::sqrt(1 - y[0]);
    return {y[1] - root, y[3] + y[2] / (2 * root), {0.5 / root, 1}, -y[2] * y[2] / (4 * root * root * root)};
  }
};

/// x = t^3 and x = 2 t^3: both hold at t = 0, with their first two derivatives, and never again together.
struct Contradiction : PlainScene {
  static constexpr std::size_t size = 1, constraints = 2;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 2> entries = {
        {{"slow", "contradiction.mbd:4", true}, {"fast", "contradiction.mbd:5", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(2), std::span(indices).first(1)}}};
    static const Description result =
        describe("contradiction", size, entries, island, {0, 1, 0.01, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 2> start() { return {0, 0}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {-9.81};
  }
  template <class State>
  ConstraintValue<size> constraint(int k, double t, const State& y) const {
    const double factor = k + 1;
    return {y[0] - factor * t * t * t, y[1] - 3 * factor * t * t, {1}, 6 * factor * t};
  }
};

/// The pendulum whose circle is required twice, once as its square: redundant, and no more than that however far the
/// state has drifted. Both rods agree that y keeps its value if it starts there at rest: rank 1 throughout.
struct Redundant : PlainScene {
  static constexpr std::size_t size = 2, constraints = 2;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 2> entries = {
        {{"circle", "redundant.mbd:4", true}, {"again", "redundant.mbd:5", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(2), std::span(indices).first(2)}}};
    static const Description result =
        describe("redundant", size, entries, island, {0, 2, 0.01, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 4> start() { return {1, 0, 0, 0}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {0, -9.81};
  }
  template <class State>
  ConstraintValue<size> constraint(int k, double, const State& y) const {
    const double s = y[0] * y[0] + y[1] * y[1];
    const double s_ = 2 * (y[0] * y[2] + y[1] * y[3]);
    const double b = -2 * (y[2] * y[2] + y[3] * y[3]);
    if (k == 0) {
      return {s - 1, s_, {2 * y[0], 2 * y[1]}, b};
    }
    return {s * s - 1, 2 * s * s_, {4 * s * y[0], 4 * s * y[1]}, 2 * s * b - 2 * s_ * s_};
  }
};

/// A slider on x * (1 - t) = 0: its row vanishes at t = 1 and returns.
struct Vanishing : PlainScene {
  static constexpr std::size_t size = 1, constraints = 1;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 1> entry = {{{"slider", "vanishing.mbd:4", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(1), std::span(indices).first(1)}}};
    static const Description result =
        describe("vanishing", size, entry, island, {0, 2, 0.125, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 2> start() { return {0, 0}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {0};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double t, const State& y) const {
    return {y[0] * (1 - t), y[1] * (1 - t) - y[0], {1 - t}, 2 * y[1]};
  }
};

/// A particle near the ellipse x^2/4 + y^2 = 1, required twice, and one whose speed is to be 2: both off at the start.
struct Loose : PlainScene {
  static constexpr std::size_t size = 4, constraints = 3;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 3> entries = {
        {{"ellipse", "loose.mbd:4", true}, {"again", "loose.mbd:5", true}, {"pace", "loose.mbd:6", false}}};
    static constexpr std::array<IslandEntry, 2> islands = {
        {{std::span(indices).first(2), std::span(indices).first(2)},
         {std::span(indices).subspan(2, 1), std::span(indices).subspan(2, 2)}}};
    static constexpr std::array<const char*, 4> positions = {"x1", "y1", "x2", "y2"};
    static constexpr std::array<const char*, 4> speeds = {"vx1", "vy1", "vx2", "vy2"};
    static const Description result = [] {
      Description d = describe("loose", size, entries, islands, {0, 0, 0.01, not_given, not_given, "rk4"});
      d.coordinates = positions;
      d.speeds = speeds;
      return d;
    }();
    return result;
  }

  static std::array<double, 8> start() { return {2, 1, 0, 0, 0.5, 0.25, 0.9, 1.2}; }
  template <class State>
  void free(double, const State&, std::array<double, size>& a) const {
    a = {};
  }
  template <class State>
  ConstraintValue<size> constraint(int k, double, const State& y) const {
    const double factor = k + 1;  // of the ellipse's two rows
    if (k < 2) {
      return {factor * (y[0] * y[0] / 4 + y[1] * y[1] - 1),
              factor * (y[0] * y[4] / 2 + 2 * y[1] * y[5]),
              {factor * y[0] / 2, factor * 2 * y[1]},
              -factor * (y[4] * y[4] / 2 + 2 * y[5] * y[5])};
    }
    return {0, y[6] * y[6] + y[7] * y[7] - 4, {0, 0, 2 * y[6], 2 * y[7]}, 0};
  }
};

/// 1e-9 x y = 0 along the x axis, with a pull t along y: the row vanishes at the start and grows with x = t.
struct Opening : PlainScene {
  static constexpr std::size_t size = 2, constraints = 1;

  static const Description& description() {
    static constexpr std::array<ConstraintEntry, 1> entry = {{{"axis", "opening.mbd:4", true}}};
    static constexpr std::array<IslandEntry, 1> island = {{{std::span(indices).first(1), std::span(indices).first(2)}}};
    static const Description result =
        describe("opening", size, entry, island, {0, 1, 0.01, not_given, not_given, nullptr});
    return result;
  }

  static std::array<double, 4> start() { return {0, 0, 1, 0}; }
  template <class State>
  void free(double t, const State&, std::array<double, size>& a) const {
    a = {0, t};
  }
  template <class State>
  ConstraintValue<size> constraint(int, double, const State& y) const {
    constexpr double factor = 1e-9;
    return {factor * y[0] * y[1],
            factor * (y[0] * y[3] + y[2] * y[1]),
            {factor * y[1], factor * y[0]},
            -2 * factor * y[2] * y[3]};
  }
};

}  // namespace mbrt::test
