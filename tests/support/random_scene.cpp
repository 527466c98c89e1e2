#include "random_scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "compiled.hpp"
#include "mechanics/point.hpp"

namespace mbcc::test {

namespace {

constexpr std::array axes = {"x", "y", "z"};

/// A number as text that reads back as the same number, in parentheses if it has a sign.
std::string exact(double x) { return std::signbit(x) ? fmt::format("({})", x) : fmt::format("{}", x); }

template <class Items>
std::string vector_text(const Items& items) {
  return items.size() == 1 ? fmt::format("{}", items[0]) : fmt::format("({})", fmt::join(items, ", "));
}

}  // namespace

RandomScene::RandomScene(Random& random) : random_(random), dimension_(1 + static_cast<int>(random.below(3))) {
  draw_particles();
  draw_constraints();
  hold_at_start();
}

std::string RandomScene::text() const { return write(particles_, constraints_); }

std::string RandomScene::rewritten(Random& random) const {
  std::vector<Particle> particles = particles_;
  std::vector<Constraint> constraints = constraints_;
  random.shuffle(particles);
  random.shuffle(constraints);
  for (Constraint& constraint : constraints) {
    constraint.factor *= std::pow(10, random.uniform(-8, 8)) * (random.chance(0.5) ? 1 : -1);
  }
  return write(particles, constraints);
}

void RandomScene::draw_particles() {
  const std::size_t count = 1 + random_.below(8);
  for (std::size_t p = 0; p < count; ++p) {
    Particle particle{std::string(1, static_cast<char>('a' + p)), std::pow(10, random_.uniform(-2, 2)), {}, {}, {}};
    for (int axis = 0; axis < dimension_; ++axis) {
      particle.position.push_back(random_.uniform(-2, 2));
      particle.velocity.push_back(random_.uniform(-2, 2));
    }
    particles_.push_back(particle);
  }
  for (Particle& particle : particles_) {
    for (int axis = 0; axis < dimension_; ++axis) {
      particle.force.push_back(random_.chance(0.3)   ? exact(random_.uniform(-10, 10))
                               : random_.chance(0.5) ? fmt::format("-3*{}*{}", coordinate(), speed())
                                                     : fmt::format("2*{} - {}", smooth_function(), coordinate()));
    }
  }
}

void RandomScene::draw_constraints() {
  const std::size_t speeds = particles_.size() * static_cast<std::size_t>(dimension_);
  const std::size_t count = random_.below(9);
  for (std::size_t k = 0; k < count; ++k) {
    const bool depends = k > 0 && (k >= speeds || random_.chance(0.25));
    Constraint constraint = depends ? dependent() : independent(random_.chance(0.6));
    constraint.name = fmt::format("k{}", k + 1);
    if (random_.chance(0.2)) {
      constraint.factor = random_.chance(0.5) ? 1e-8 : 1e8;
    }
    constraints_.push_back(constraint);
  }
}

RandomScene::Constraint RandomScene::independent(bool holonomic) {
  Constraint constraint;
  constraint.holonomic = holonomic;
  constraint.body = holonomic ? holonomic_body() : nonholonomic_body();
  return constraint;
}

std::string RandomScene::coordinate() {
  return random_.pick(particles_).name + "." + axes[random_.below(static_cast<std::size_t>(dimension_))];
}
std::string RandomScene::speed() {
  return random_.pick(particles_).name + ".v" + axes[random_.below(static_cast<std::size_t>(dimension_))];
}

std::string RandomScene::distance() {
  const std::string& one = random_.pick(particles_).name;
  const std::string& other = random_.pick(particles_).name;
  if (dimension_ == 1) {
    return one == other ? one + ".x^2" : fmt::format("({}.x - {}.x)", one, other);
  }
  return one == other ? fmt::format("norm({}.position)", one)
                      : fmt::format("norm({}.position - {}.position)", one, other);
}

std::string RandomScene::smooth_function() {
  static constexpr std::array names = {"sin", "cos", "exp", "tanh", "atan", "sinh"};
  return fmt::format("{}({}*{})", random_.pick(names), exact(random_.uniform(-1, 1)), coordinate());
}

std::string RandomScene::holonomic_body() {
  switch (random_.below(6)) {
    case 0:
      return distance() + "^2";
    case 1:
      return distance();
    case 2:
      return fmt::format("{} - 2*{} + {}", coordinate(), coordinate(), coordinate());
    case 3:
      return fmt::format("{}*{} + {}", coordinate(), coordinate(), coordinate());
    case 4:
      return fmt::format("{} + {}*{}", smooth_function(), smooth_function(), coordinate());
    default:
      return fmt::format("{}*cos(2*t) + {}*sin(t)", coordinate(), coordinate());
  }
}

std::string RandomScene::nonholonomic_body() {
  switch (random_.below(4)) {
    case 0:
      return fmt::format("{}*{} - {}*{}", coordinate(), speed(), coordinate(), speed());
    case 1:
      return fmt::format("{}^2 + {}^2 + {}*{}", speed(), speed(), speed(), coordinate());
    case 2:
      return fmt::format("{}*{} + {}", smooth_function(), speed(), speed());
    default:
      return fmt::format("{} - t*{}", speed(), speed());
  }
}

/// Another constraint again, a combination of two, or one that is nearly another: from beyond the cut-off of the rank,
/// 1e-8, to well within it.
RandomScene::Constraint RandomScene::dependent() {
  static constexpr std::array distances = {"1e-12", "1e-9", "1e-6", "1e-5", "1e-4", "1e-3", "1e-2"};
  const Constraint one = random_.pick(constraints_);
  const Constraint other = random_.pick(constraints_);
  Constraint result = independent(one.holonomic);
  if (random_.chance(0.3)) {
    result.body = one.body;
  } else if (random_.chance(0.4) && one.holonomic == other.holonomic) {
    result.body = fmt::format("({}) - 3*({})", one.body, other.body);
  } else {
    result.body = fmt::format("({}) + {}*({})", one.body, random_.pick(distances), result.body);
  }
  return result;
}

/// Takes from every constraint the value that it has at the start and, if it is holonomic, its rate.
void RandomScene::hold_at_start() {
  std::string text = write(particles_, {});
  for (const Constraint& constraint : constraints_) {
    text += fmt::format("output {} = {}\n", constraint.name, constraint.body);
  }
  const Compilation measured = compiled(text, Stage::Equations);
  const mechanics::Equations& equations = measured.equations;
  const mechanics::Point start = mechanics::initial_point(*measured.system, equations);
  const std::vector<double> values = mechanics::values_at(start, equations.outputs);
  const std::vector<double> rates =
      mechanics::values_at(start, mechanics::rates_of(equations.outputs, equations.kinematics));
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    constraints_[k].value = values[k];
    constraints_[k].rate = constraints_[k].holonomic ? rates[k] : 0;
  }
}

std::string RandomScene::write(const std::vector<Particle>& particles,
                               const std::vector<Constraint>& constraints) const {
  std::string text = fmt::format("system scene\ndimension {}\n", dimension_);
  for (const Particle& particle : particles) {
    text += fmt::format("particle {} {{ mass = {}; position = {}; velocity = {}; force = {} }}\n", particle.name,
                        particle.mass, vector_text(particle.position), vector_text(particle.velocity),
                        vector_text(particle.force));
  }
  for (const Constraint& constraint : constraints) {
    text += fmt::format("constraint {} : {}*({} - {} - {}*t) = 0\n", constraint.name, exact(constraint.factor),
                        constraint.body, exact(constraint.value), exact(constraint.rate));
  }
  return text;
}

}  // namespace mbcc::test
