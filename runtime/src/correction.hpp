#pragma once
// The shortest way onto the constraints, to first order: Note [nearest start] in assemble.hpp.

#include <span>
#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

/// What counts as the error of a constraint: a sum of its value and its rate, or where it is nonholonomic a multiple of
/// its value; if that multiple is zero, nonholonomic constraints do not count.
struct ErrorTerms {
  double position;
  double velocity;
  double nonholonomic;
};
inline constexpr ErrorTerms errors_of_position = {1, 0, 0};  ///< removed by moving coordinates
inline constexpr ErrorTerms errors_of_velocity = {0, 1, 1};  ///< removed by changing speeds

/// `climb` where the rows are off their constraints.
///
/// Note [off the constraints]: at a distance d from the constraints, relative to the state, redundant rows are
/// independent by about d. The cut-off is raised to d, so that they do not turn into noise divided by noise. Nothing is
/// left in the record: it tells of accelerations.
void climb_off(const Island& island, double relative_distance, std::span<double> added);

class Correction {
 public:
  Correction(AnyModel& model, const std::vector<Island>& islands);

  /// All errors at `state` and the model's time together, in units of the scaled rows; infinite where one is no number.
  double size(const ErrorTerms& terms, std::span<const double> state);

  /// The shortest displacement by mass, one number per speed, that the rows at `state` turn into A moved - errors as
  /// far as they can. `moved` may be empty and stand for zero; `held`, if not empty, marks what must not change:
  /// speeds, or in a displacement of positions coordinates. Solved by `climb_off`.
  std::span<const double> step(const ErrorTerms& terms, std::span<const double> state,
                               std::span<const double> moved = {}, const std::vector<bool>& held = {});

  /// How the coordinates move with a displacement along the speeds.
  std::span<const double> coordinates_of(std::span<const double> state, std::span<const double> along_speeds);

 private:
  bool counts(const ErrorTerms& terms, std::size_t island, std::size_t row) const;
  double error(const ErrorTerms& terms, std::size_t island, std::size_t row) const;
  void fill_rate(std::span<const double> along_speeds);
  std::vector<std::vector<double>> held_directions(const ErrorTerms& terms, std::size_t island,
                                                   std::span<const double> state, const std::vector<bool>& held);
  double fill_residuals(const ErrorTerms& terms, std::size_t island, std::span<const double> moved);
  void solve(std::size_t island, double relative_distance);

  AnyModel& model_;
  const Description& description_;
  const std::vector<Island>& islands_;
  std::vector<double> step_;
  std::vector<double> added_;      // of one island
  std::vector<double> rate_;       // a change in the place of the speeds
  std::vector<double> uncoupled_;  // per speed
  std::vector<double> moved_;      // per coordinate
};

}  // namespace mbrt
