#pragma once
// Emitted code, an expert's code and the generic way on the same scenes.

#include <optional>
#include <vector>

#include "measure.hpp"

namespace bench {

struct Result {
  std::string contender;
  Timing timing;
  std::optional<double> error;  ///< at the scene's end, against the reference; absent where a run would take too long
  double disagreement;          ///< largest difference from the expert's state after the same number of steps
};

struct Comparison {
  Scene scene;
  std::vector<Result> results;

  const Result* find(std::string_view contender) const;
  /// Whether all contenders computed this scene: the end within the method's error, the states equal up to rounding.
  bool agrees() const;
};

Comparison compare(const Scene& scene, Effort effort);

/// Prints the comparisons as a table.
void print(const std::vector<Comparison>& comparisons);

}  // namespace bench
