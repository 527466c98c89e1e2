#pragma once
// The linear systems of an implicit method: a Jacobian J, and the factors of two matrices that are made of it.

#include <cstddef>
#include <span>
#include <vector>

#include "mbrt/radau_coefficients.hpp"

namespace mbrt {

/// A component whose rate is another one, as that of a coordinate is its speed.
struct Follower {
  std::size_t component;
  std::size_t leader;
};

/// s I - J for one real s and one complex s. Dense; followers are eliminated beforehand, so that half of the unknowns
/// of a system of particles remain (section IV.8 of Hairer and Wanner, volume II, has it for equations of second
/// order).
///
/// Allocates when it is made; large systems also for the time of a factorisation.
class StageSystems {
 public:
  explicit StageSystems(std::size_t size);
  StageSystems(StageSystems&&) noexcept;
  ~StageSystems();

  /// Column j of J, to be filled.
  std::span<double> column(std::size_t j);
  /// After J has changed; whether all of it is finite.
  bool take_jacobian();
  /// Rows of J that are a single 1: at its state these components follow, if not everywhere.
  std::span<const Follower> followers() const;
  void factorise(double real, radau::Complex complex);

  /// Replaces the right side by the solution of the real system.
  void solve(std::span<double> right);
  /// Likewise of the complex system; real and imaginary parts.
  void solve(std::span<double> real, std::span<double> imaginary);

 private:
  struct Matrices;
  std::vector<Matrices> matrices_;  ///< one; <memory> would bring streams along
};

}  // namespace mbrt
