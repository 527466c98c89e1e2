#pragma once
// What the solves of all islands have recorded, and how to evaluate a model without leaving a trace in it.

#include <vector>

#include "mbrt/any_model.hpp"

namespace mbrt {

inline std::vector<Island> islands_of(AnyModel& model) {
  std::vector<Island> islands;
  for (std::size_t k = 0; k < model.description().islands.size(); ++k) {
    islands.push_back(model.island(static_cast<int>(k)));
  }
  return islands;
}

inline std::size_t state_size(const Description& model) { return model.coordinates.size() + model.speeds.size(); }

/// Keeps the records of the islands as they were while an evaluation is made that is not part of the integration.
class Untraced {
 public:
  explicit Untraced(const std::vector<Island>& islands) : islands_(islands) {
    for (const Island& island : islands_) {
      kept_.push_back(*island.record);
    }
  }
  ~Untraced() {
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      *islands_[k].record = kept_[k];
    }
  }
  Untraced(const Untraced&) = delete;
  Untraced& operator=(const Untraced&) = delete;

 private:
  const std::vector<Island>& islands_;
  std::vector<IslandRecord> kept_;
};

}  // namespace mbrt
