#pragma once
// A model without a compiler: turns a scene written by hand into what `mbrt::Model` asks for, the plain way.
//
// A scene has unit masses and as many speeds as coordinates:
//   static constexpr std::size_t size, constraints;      numbers of coordinates and of constraints
//   static const Description& description();
//   static std::array<double, 2 * size> start();
//   void prepare();  double p[...];                       parameters, in the order of the description
//   void free(t, y, a)                                    accelerations without constraints
//   ConstraintValue<size> constraint(k, t, y)
//   double energy(y);  void outputs(t, y, rate, values)

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mbrt/model.hpp"

namespace mbrt::test {

/// One constraint at one state: h and h' (nonholonomic: 0 and g), and row and right side of A u' = b.
template <std::size_t Size>
struct ConstraintValue {
  double value;
  double rate;
  std::array<double, Size> row;
  double b;
};

template <class Scene>
class SampleModel {
 public:
  static constexpr std::size_t size = Scene::size;
  using State = std::array<double, 2 * size>;

  SampleModel() {
    for (const IslandEntry& entry : description().islands) {
      islands_.emplace_back(entry.constraints.size(), entry.speeds.size());
    }
  }

  const Description& description() const { return Scene::description(); }
  std::span<double> parameters() { return scene_.parameters; }
  void prepare() { scene_.prepare(); }
  State initial_state() const { return scene_.start(); }
  void set_time(double time) {
    ++times_set;
    time_ = time;
  }

  void rates(const State& y, State& rate) {
    ++evaluations;
    std::array<double, size> acceleration;
    scene_.free(time_, y, acceleration);
    for (std::size_t k = 0; k < islands_.size(); ++k) {
      island_rows(static_cast<int>(k), y);
      solve(islands_[k]);
      const auto speeds = description().islands[k].speeds;
      for (std::size_t j = 0; j < speeds.size(); ++j) {
        acceleration[static_cast<std::size_t>(speeds[j])] += islands_[k].added[j];
      }
    }
    for (std::size_t i = 0; i < size; ++i) {
      rate[i] = y[size + i];
      rate[size + i] = acceleration[i];
    }
  }

  Island island(int k) { return islands_[static_cast<std::size_t>(k)].view(); }

  void island_rows(int k, const State& y) {
    const IslandEntry& entry = description().islands[static_cast<std::size_t>(k)];
    const IslandRows rows = island(k).rows;
    std::array<double, size> free;
    scene_.free(time_, y, free);
    for (std::size_t i = 0; i < entry.constraints.size(); ++i) {
      const auto constraint = scene_.constraint(entry.constraints[i], time_, y);
      rows.residual[i] = constraint.b;
      rows.position[i] = constraint.value;
      rows.velocity[i] = constraint.rate;
      for (std::size_t j = 0; j < entry.speeds.size(); ++j) {
        const auto speed = static_cast<std::size_t>(entry.speeds[j]);
        rows.matrix[i * entry.speeds.size() + j] = constraint.row[speed];
        rows.residual[i] -= constraint.row[speed] * free[speed];
        rows.free[j] = free[speed];
        rows.mobility[j] = 1;
      }
    }
  }

  void constraint_errors(const State& y, const State& rate, std::span<double> position, std::span<double> velocity,
                         std::span<double> acceleration) const {
    for (std::size_t k = 0; k < Scene::constraints; ++k) {
      const auto constraint = scene_.constraint(static_cast<int>(k), time_, y);
      position[k] = constraint.value;
      velocity[k] = constraint.rate;
      acceleration[k] = -constraint.b;
      for (std::size_t j = 0; j < size; ++j) {
        acceleration[k] += constraint.row[j] * rate[size + j];
      }
    }
  }

  double energy(const State& y) const { return scene_.energy(y); }
  void outputs(const State& y, const State& rate, std::span<double> values) const {
    scene_.outputs(time_, y, rate, values);
  }
  void applied_forces(const State& y, std::span<double> values) const {
    std::array<double, size> free;
    scene_.free(time_, y, free);
    std::copy_n(free.begin(), values.size(), values.begin());
  }

  long evaluations = 0;
  long times_set = 0;

 private:
  struct IslandArrays {
    IslandArrays(std::size_t m, std::size_t n)
        : scale(m),
          floor(m),
          scratch(scratch_size(m, n)),
          matrix(m * n),
          residual(m),
          free(n),
          mobility(n),
          position(m),
          velocity(m),
          added(n) {
      record.rank = static_cast<int>(m);
    }
    Island view() { return {scale, floor, scratch, {matrix, residual, free, mobility, position, velocity}, &record}; }

    std::vector<double> scale, floor, scratch, matrix, residual, free, mobility, position, velocity, added;
    IslandRecord record;
  };

  /// Step 1 of the ladder for single rows; more rows climb at once.
  static void solve(IslandArrays& island) {
    double square = 0;
    for (const double entry : island.matrix) {
      square += entry * entry;
    }
    if (island.residual.size() > 1 || !holds(square, square, island.floor[0], 1)) {
      climb(island.view(), island.added);
      return;
    }
    for (std::size_t j = 0; j < island.added.size(); ++j) {
      island.added[j] = island.matrix[j] * island.residual[0] / square;
    }
  }

  Scene scene_;
  double time_ = 0;
  std::vector<IslandArrays> islands_;
};

}  // namespace mbrt::test
