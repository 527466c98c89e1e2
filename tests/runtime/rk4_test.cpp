// The classical Runge-Kutta method as a template, without the program around it.

#include "mbrt/rk4.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "allocations.hpp"
#include "equation.hpp"
#include "sample_model.hpp"
#include "scenes.hpp"

using namespace mbrt;
using namespace mbrt::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

template <class M>
typename M::State end_of(M& model, typename M::State y, const TimeGrid& grid) {
  Unobserved nobody;
  rk4(model, y, grid, nobody);
  return y;
}

}  // namespace

TEST_CASE("steps fill the span, the last one shortened") {
  CHECK(time_grid(0, 5, 0.005).steps == 1000);
  CHECK(time_grid(0, 0.3, 0.1).steps == 3);  // 0.3/0.1 is above 3 by one rounding
  CHECK(time_grid(1, 1, 0.1).steps == 0);
  CHECK(time_grid(1, 1, 0.1).time(0) == 1);
  CHECK(time_grid(0, 2, 1e300).steps == 1);
  const TimeGrid grid = time_grid(-1, 0, 0.3);
  CHECK(grid.steps == 4);
  CHECK(grid.time(3) == -1 + 3 * 0.3);
  CHECK(grid.time(4) == 0);
}

TEST_CASE("a quadrature of t^3 is exact, on a shortened step too") {
  auto cubic = equation<std::array<double, 1>>([](double t, const auto&, auto& rate) { rate[0] = 4 * t * t * t; });
  // Simpson's rule is exact for cubics; each step rounds once.
  CHECK(end_of(cubic, {0}, time_grid(0, 1, 0.3))[0] == Approx(1).epsilon(4 * eps));
}

TEST_CASE("the error falls with the fourth power of the step") {
  auto circle = equation<std::array<double, 2>>([](double, const auto& y, auto& rate) { rate = {-y[1], y[0]}; });
  const auto error = [&](double step) {
    const auto y = end_of(circle, {1, 0}, time_grid(0, 1, step));
    return std::hypot(y[0] - std::cos(1), y[1] - std::sin(1));
  };
  // 2^4 up to the next order, a relative change of about the step.
  CHECK(error(1.0 / 32) / error(1.0 / 64) == Approx(16).epsilon(1.0 / 32));
}

TEST_CASE("each time is set once, and each step costs four evaluations") {
  auto rest = equation<std::array<double, 1>>([](double, const auto&, auto& rate) { rate[0] = 0; });
  end_of(rest, {0}, time_grid(0, 1, 0.4));
  CHECK(rest.evaluations == 4 * 3 + 1);
  const std::vector<double> expected = {0, 0.2, 0.4, 0.6, 0.8, 0.9, 1};
  REQUIRE(rest.times.size() == expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(rest.times[i] == Approx(expected[i]).epsilon(2 * eps));
  }
}

TEST_CASE("states may be vectors") {
  const auto turn = [](double, const auto& y, auto& rate) {
    rate[0] = -y[1];
    rate[1] = y[0];
  };
  auto fixed = equation<std::array<double, 2>>(turn);
  auto dynamic = equation<std::vector<double>>(turn);
  const auto a = end_of(fixed, {1, 0}, time_grid(0, 1, 0.1));
  const auto b = end_of(dynamic, {1, 0}, time_grid(0, 1, 0.1));
  CHECK(a[0] == b[0]);
  CHECK(a[1] == b[1]);
}

TEST_CASE("observers see every accepted state with its rate, and may end the run") {
  struct Until {
    long arrived = 0;
    std::vector<double> times = {};
    void arriving() { ++arrived; }
    bool accepted(double time, const std::array<double, 1>& y, const std::array<double, 1>& rate) {
      CHECK(y[0] == Approx(2 * time).margin(8 * eps));
      CHECK(rate[0] == 2);
      times.push_back(time);
      return time < 0.45;
    }
  } until;
  auto line = equation<std::array<double, 1>>([](double, const auto&, auto& rate) { rate[0] = 2; });
  std::array<double, 1> y = {0};
  rk4(line, y, time_grid(0, 1, 0.25), until);
  CHECK(until.times == std::vector<double>{0, 0.25, 0.5});
  CHECK(until.arrived == 3);
}

TEST_CASE("no step allocates") {
  SampleModel<Paper> model;  // its second island meets the pinv at t = 3
  auto y = model.initial_state();
  model.prepare();
  model.set_time(0);
  for (int k = 0; k < 2; ++k) {
    model.island_rows(k, y);
    take_scales(model.island(k));
  }
  Unobserved nobody;
  const long before = allocations();
  rk4(model, y, time_grid(0, 5, 0.005), nobody);
  CHECK(allocations() == before);
  CHECK(model.island(1).record->pinv > 0);
}
