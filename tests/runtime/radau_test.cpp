// The implicit method as a template: coefficients, order, stiffness, what lies between its steps, its counts.

#include "mbrt/radau.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "allocations.hpp"
#include "circle.hpp"
#include "equation.hpp"

using namespace mbrt;
using namespace mbrt::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

radau::Matrix multiply(const radau::Matrix& a, const radau::Matrix& b) {
  radau::Matrix result{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) {
        result[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return result;
}

/// The method's matrix A from its nodes: collocation integrates 1, t and t^2 exactly.
radau::Matrix matrix_of_nodes() {
  radau::Matrix powers{}, integrals{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double exponent = static_cast<double>(k);
      powers[i][k] = std::pow(radau::nodes[i], exponent);
      integrals[i][k] = std::pow(radau::nodes[i], exponent + 1) / (exponent + 1);
    }
  }
  return multiply(integrals, radau::inverse(powers));
}

/// q'' = -q as coordinate and speed.
auto spring() {
  return equation<std::array<double, 2>>([](double, const auto& y, auto& rate) { rate = {y[1], -y[0]}; });
}

/// y' = -L (y - cos t) - sin t: every solution falls onto cos t within a time of 1/L.
auto attracted_to_cosine() {
  return equation<std::array<double, 1>>(
      [](double t, const auto& y, auto& rate) { rate[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t); });
}

}  // namespace

TEST_CASE("the blocks of Radau IIA are those of the inverse of its matrix") {
  const auto [real, complex] = std::pair(radau::real_eigenvalue, radau::eigenvalue);
  const radau::Matrix blocks = {
      {{real, 0, 0}, {0, complex.real, -complex.imaginary}, {0, complex.imaginary, complex.real}}};
  const radau::Matrix a = matrix_of_nodes();
  const radau::Matrix back = multiply(a, multiply(radau::from_blocks, blocks));
  const radau::Matrix identity = multiply(radau::to_blocks, radau::from_blocks);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(back[i][j] == Approx(radau::from_blocks[i][j]).margin(100 * eps));  // the condition of the powers is 50
      CHECK(identity[i][j] == Approx(i == j ? 1 : 0).margin(10 * eps));
    }
  }
}

TEST_CASE("steps of Radau IIA have order 5, and errors follow the tolerance") {
  std::array<double, 3> errors{}, steps{};
  for (std::size_t i = 0; i < 3; ++i) {
    auto model = circle();
    std::array<double, 2> y = {1, 0};
    const double tolerance = std::pow(10.0, -6 - 2 * static_cast<double>(i));
    steps[i] = static_cast<double>(run_to<Radau>(model, y, task(0, 10, tolerance)).steps);
    errors[i] = std::hypot(y[0] - std::cos(10), y[1] - std::sin(10));
    CHECK(errors[i] < 10 * tolerance);  // ten units of time: not more than a tolerance per unit
  }
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(std::log(errors[i] / errors[i + 1]) / std::log(steps[i + 1] / steps[i]) == Approx(5).margin(0.3));
  }
}

TEST_CASE("the length of steps follows the motion, not the stiffness") {
  auto model = attracted_to_cosine();
  std::array<double, 1> y = {1.5};
  const Course course = run_to<Radau>(model, y, task(0, 10, 1e-6));
  CHECK(course.ending == Ending::Complete);
  CHECK(course.steps < 50);  // an explicit method takes more than 10 * 1e6 / 10
  CHECK(y[0] == Approx(std::cos(10)).margin(1e-6));
  CHECK(course.jacobians == 1);    // the equation is linear
  CHECK(course.differenced == 1);  // and has no code for it
}

TEST_CASE("coordinates and speeds are known between steps as at their ends") {
  for (const double tolerance : {1e-6, 1e-8, 1e-10}) {
    double worst = 0, last = 0;
    Watching observer{[&](double t, const auto& between) {
      for (const double part : {0.25, 0.5, 0.75}) {
        const double at = last + part * (t - last);
        std::array<double, 2> y{};
        between(at, y);
        worst = std::max(worst, std::hypot(y[0] - std::cos(at), y[1] + std::sin(at)));
      }
      last = t;
      return true;
    }};
    auto model = spring();
    std::array<double, 2> y = {1, 0};
    CHECK(Radau::run(model, y, task(0, 5, tolerance), observer).steps > 5);
    INFO(tolerance << ": " << worst);
    CHECK(worst < 10 * tolerance);
  }
}

TEST_CASE("every evaluation of an implicit step is counted, and none is beyond the end") {
  auto model = attracted_to_cosine();
  std::array<double, 1> y = {1.5};
  const Course course = run_to<Radau>(model, y, task(0, 1, 1e-6));
  CHECK(course.evaluations == model.evaluations);
  CHECK(*std::max_element(model.times.begin(), model.times.end()) == 1);
  CHECK(course.factorisations >= course.jacobians);
  CHECK(course.factorisations <= course.steps + course.rejected);
}

TEST_CASE("implicit steps end before what has no rate, and say which component") {
  auto edge = equation<std::array<double, 2>>([](double t, const auto&, auto& rate) { rate = {1, std::sqrt(1 - t)}; });
  std::array<double, 2> y = {0, 0};
  const Course course = run_to<Radau>(edge, y, task(0, 2, 1e-9));
  CHECK(course.ending == Ending::NotFinite);
  CHECK(course.time == Approx(1).epsilon(16 * eps));

  auto pole = equation<std::array<double, 2>>([](double, const auto& z, auto& rate) { rate = {1, z[1] * z[1]}; });
  std::array<double, 2> z = {0, 1};  // 1/(1 - t)
  const Course ended = run_to<Radau>(pole, z, task(0, 2, 1e-9));
  CHECK(ended.ending != Ending::Complete);
  CHECK(ended.time == Approx(1).epsilon(1e-6));
  CHECK(ended.component == 1);
}

TEST_CASE("no implicit step allocates once the first is done") {
  // Without the record of times that `equation` keeps.
  struct Oscillator {
    using State = std::array<double, 2>;
    void set_time(double) {}
    void rates(const State& y, State& rate) { rate = {y[1], -y[0] * y[0] * y[0]}; }
  };
  long steps = 0, first = 0, last = 0;
  Watching observer{[&](double, const auto&) {
    (++steps == 1 ? first : last) = allocations();
    return true;
  }};
  Oscillator model;
  std::array<double, 2> y = {1, 0};
  const Course course = Radau::run(model, y, task(0, 10, 1e-6), observer);
  CHECK(course.jacobians > 5);
  CHECK(first == last);
}
