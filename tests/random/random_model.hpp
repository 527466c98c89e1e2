#pragma once
// Random models over the whole language, as text: names that C++ reserves, loops, sums, vectors, conditions, rates,
// unused things, deep nesting.

#include <string>
#include <vector>

#include "support/random.hpp"

namespace mbcc::test {

class RandomModel {
 public:
  explicit RandomModel(Random& random);

  /// Constraints hold at the start; mbcc accepts most of these models, not all: some contradict themselves.
  std::string text() const;

 private:
  /// body = value + rate*t
  struct Constraint {
    std::string heading, body;
    bool holonomic = true;
    double value = 0, rate = 0;
  };
  /// What a leaf may be.
  enum class Of { Motion, Coordinates, Everything };  ///< Everything: accelerations too

  std::string declare();
  void draw_values();
  void draw_particle(const std::string& name, const std::string& prefix, const std::string& suffix);
  void draw_particles();
  void draw_loop();
  void draw_definitions();
  void draw_forces();
  void draw_constraints();
  void draw_outputs();
  void hold_at_start();

  std::string number();
  std::string leaf(Of of);
  std::string condition(Of of, int depth);
  std::string application(Of of, int depth);
  std::string expression(Of of, int depth);
  std::string nested(Of of, int depth);
  std::string force();  ///< a vector, or a number in dimension 1

  Random& random_;
  std::size_t dimension_;
  std::vector<std::string> names_;       ///< not used yet
  std::vector<std::string> statements_;  ///< but for constraints
  std::vector<std::string> targets_;     ///< what forces act on
  std::vector<std::string> coordinates_, speeds_, accelerations_, values_, vectors_;
  std::string loop_;  ///< `name` of particles name[1] .. name[loop_size_], or empty
  std::size_t loop_size_ = 0;
  std::vector<Constraint> constraints_;
};

}  // namespace mbcc::test
