#pragma once
// Random scenes of particles, forces and constraints, as model text. Their constraints hold at their start, whatever
// they are, and some of them depend on others: exactly, or nearly.

#include <string>
#include <vector>

#include "random.hpp"

namespace mbcc::test {

class RandomScene {
 public:
  /// One to eight particles in one to three dimensions, up to eight constraints.
  explicit RandomScene(Random& random);

  std::string text() const;
  /// The same scene: particles and constraints in another order, constraints times factors from 1e-8 to 1e8.
  std::string rewritten(Random& random) const;

 private:
  struct Particle {
    std::string name;
    double mass;
    std::vector<double> position, velocity;
    std::vector<std::string> force;
  };
  /// factor*(body - value - rate*t) = 0
  struct Constraint {
    std::string name, body;
    bool holonomic = true;
    double factor = 1, value = 0, rate = 0;
  };

  void draw_particles();
  void draw_constraints();
  Constraint independent(bool holonomic);
  Constraint dependent();
  std::string coordinate();
  std::string speed();
  std::string distance();
  std::string smooth_function();
  std::string holonomic_body();
  std::string nonholonomic_body();
  void hold_at_start();
  std::string write(const std::vector<Particle>& particles, const std::vector<Constraint>& constraints) const;

  Random& random_;
  int dimension_;
  std::vector<Particle> particles_;
  std::vector<Constraint> constraints_;
};

}  // namespace mbcc::test
