// The method of Dormand and Prince and the driver of methods that choose their steps, as templates.

#include "mbrt/dop853.hpp"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "allocations.hpp"
#include "circle.hpp"
#include "equation.hpp"
#include "sample_model.hpp"
#include "scenes.hpp"

using namespace mbrt;
using namespace mbrt::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("quadratures up to the order are exact, between steps too") {
  // t^7 is integrated exactly by order 8; the interpolant of degree 7 holds t^6's integral.
  auto power = equation<std::array<double, 2>>([](double t, const auto&, auto& rate) {
    rate = {8 * std::pow(t, 7), 7 * std::pow(t, 6)};
  });
  double worst = 0;
  Watching observer{[&](double t, const auto& between) {
    std::array<double, 2> y{};
    between(0.9 * t, y);
    worst = std::max(worst, std::abs(y[1] - std::pow(0.9 * t, 7)));
    return true;
  }};
  std::array<double, 2> y = {0, 0};
  const Course course = Dop853::run(power, y, task(0, 1, 1e-6), observer);
  // Weights up to 44 multiply roundings of numbers up to 8.
  CHECK(y[0] == Approx(1).epsilon(44 * 8 * eps));
  CHECK(y[1] == Approx(1).epsilon(44 * 8 * eps));
  CHECK(worst < 400 * 8 * eps);  // the interpolant's weights go up to 500
  CHECK(course.ending == Ending::Complete);
}

TEST_CASE("errors follow the tolerance in proportion, and the steps its eighth root") {
  std::array<double, 3> errors{};
  std::array<long, 3> steps{};
  for (std::size_t i = 0; i < 3; ++i) {
    auto model = circle();
    std::array<double, 2> y = {1, 0};
    steps[i] = run_to<Dop853>(model, y, task(0, 100, std::pow(10.0, -5 - 4 * static_cast<double>(i)))).steps;
    errors[i] = std::hypot(y[0] - std::cos(100), y[1] - std::sin(100));
  }
  for (std::size_t i = 0; i < 2; ++i) {
    // 1e4 in tolerance; its estimate is of order 7 where the error is of order 8, so that errors fall a little faster.
    CHECK(std::log10(errors[i] / errors[i + 1]) == Approx(4.5).margin(0.7));
    CHECK(static_cast<double>(steps[i + 1]) / static_cast<double>(steps[i]) == Approx(std::pow(10, 0.5)).epsilon(0.15));
  }
  CHECK(errors[0] < 100 * 1e-5);  // 100 units of time: not more than a tolerance per unit
}

TEST_CASE("no evaluation is beyond the end, all are counted, and eleven make a step") {
  auto model = circle();
  std::array<double, 2> y = {1, 0};
  const Course course = run_to<Dop853>(model, y, task(0, 10, 1e-9));
  CHECK(*std::max_element(model.times.begin(), model.times.end()) == 10);
  CHECK(course.time == 10);
  CHECK(course.evaluations == model.evaluations);
  // One at the start and one to choose the first step; eleven for each that is tried and one where it is accepted.
  CHECK(course.evaluations == 2 + 12 * course.steps + 11 * course.rejected);
}

TEST_CASE("a span of no length is its own end") {
  auto model = circle();
  std::array<double, 2> y = {1, 0};
  const Course course = run_to<Dop853>(model, y, task(3, 3, 1e-9));
  CHECK(course.ending == Ending::Complete);
  CHECK(course.steps == 0);
  CHECK(y == std::array<double, 2>{1, 0});
}

TEST_CASE("the last steps share what is left") {
  CHECK(landing(0, 0.995, 1) == 1);
  CHECK(landing(0, 2, 1) == 1);
  CHECK(landing(0, 0.9, 1) == 0.5);
  CHECK(landing(0, 0.4, 1) == 0.4);
}

TEST_CASE("a pole ends the run just before it, with the component that cannot follow") {
  auto pole = equation<std::array<double, 2>>([](double, const auto& y, auto& rate) { rate = {1, y[1] * y[1]}; });
  std::array<double, 2> y = {0, 1};  // y = 1/(1 - t)
  const Course course = run_to<Dop853>(pole, y, task(0, 2, 1e-9));
  CHECK(course.ending != Ending::Complete);
  CHECK(course.time == Approx(1).epsilon(1e-6));  // the error that has built up to there moves the pole by its size
  CHECK(course.component == 1);
}

TEST_CASE("a rate that is no number in a trial step shortens it; where nothing helps the run ends there") {
  auto edge = equation<std::array<double, 1>>([](double t, const auto&, auto& rate) { rate[0] = std::sqrt(1 - t); });
  std::array<double, 1> y = {0};
  const Course course = run_to<Dop853>(edge, y, task(0, 2, 1e-9));
  CHECK(course.ending == Ending::NotFinite);
  CHECK(course.rejected > 0);
  CHECK(course.time == Approx(1).epsilon(16 * eps));  // steps shrink to the last that the time resolves
  CHECK(y[0] == Approx(2.0 / 3).epsilon(1e-8));
}

TEST_CASE("observers may end the run") {
  long seen = 0;
  Watching observer{[&](double, const auto&) { return ++seen < 2; }};
  auto model = circle();
  std::array<double, 2> y = {1, 0};
  const Course course = Dop853::run(model, y, task(0, 10, 1e-9), observer);
  CHECK(course.ending == Ending::Stopped);
  CHECK(course.steps == 2);
  CHECK(seen == 2);
}

TEST_CASE("scales change with the units of length and time") {
  const std::array<double, 4> state = {0.5, -2, 3, 1}, rate = {3, 1, 8, 9.5};
  const Scales scales = scales_of(state, rate, 2);
  CHECK(scales.of(0) == 2);
  CHECK(scales.of(2) == Approx(std::sqrt(9.5 * 2)));  // faster than 3
  const std::array<double, 4> origin = {0, 0, 3, 1}, at_rest = {0, 0, 0, 0};
  CHECK(scales_of(origin, rate, 2).of(1) == Approx(9 / 9.5));
  CHECK(scales_of(at_rest, at_rest, 2).of(0) == 1);
  CHECK(scales_of(at_rest, at_rest, 2).of(3) == 1);
}

TEST_CASE("no adaptive step allocates") {
  SampleModel<Paper> model;
  auto y = model.initial_state();
  model.prepare();
  model.set_time(0);
  for (int k = 0; k < 2; ++k) {
    model.island_rows(k, y);
    take_scales(model.island(k));
  }
  auto inside = y;
  Watching observer{[&](double t, const auto& between) {
    between(t - 1e-3, inside);
    return true;
  }};
  const long before = allocations();
  Dop853::run(model, y, task(0, 5, 1e-9), observer);
  CHECK(allocations() == before);
}
