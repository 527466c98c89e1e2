#pragma once
// One way to integrate a problem from 0 to its end, at any tolerance.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bench::series {

struct Contender {
  std::string name;
  /// The state at the end, coordinates and then speeds in the order of the model.
  std::function<std::vector<double>(double tolerance)> integrate;
};

/// The emitted model of a problem by `taylor` and by `dop853`; empty where this build has no mbcc.
std::vector<Contender> emitted(std::string_view model);

/// The chain by hand, where there is one of so many links.
std::optional<Contender> by_hand(std::string_view model, double to);

}  // namespace bench::series
