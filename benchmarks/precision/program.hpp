#pragma once
// The emitted models by name.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "precision/contender.hpp"
#include "precision/problems.hpp"

namespace bench::precision {

/// An emitted model: its own start, and the ways to integrate it. Components are coordinates and then speeds, in the
/// order of declaration.
struct Program {
  std::vector<std::string> names;
  std::vector<double> start;
  std::function<std::vector<Contender>(const Problem&)> contenders;
};

/// Nothing if there is no model of that name.
std::optional<Program> program_of(std::string_view model);

}  // namespace bench::precision
