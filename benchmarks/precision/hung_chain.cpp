#include "precision/hung_chain.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace bench::precision {

namespace {

/// How the models of this kind are declared.
struct Layout {
  const char* model;
  std::size_t axes;
  std::size_t pinned;  ///< particles before the first that moves
  std::optional<std::array<double, 3>> far_end;
};

const std::array layouts = {
    Layout{"spherical_pendulum", 3, 0, {}},
    Layout{"chain_3", 3, 0, {}},
    Layout{"chain_10", 3, 0, {}},
    Layout{"chain_50", 3, 0, {}},
    Layout{"chain_200", 3, 0, {}},
    Layout{"four_bar", 2, 0, std::array<double, 3>{2, 0, 0}},
    Layout{"closed_ring", 3, 1, std::array<double, 3>{0, 0, 0}},
};

std::size_t axis_of(const Layout& layout, std::size_t component) {
  const std::size_t axis = component % layout.axes;
  return layout.axes == 2 && axis == 1 ? 2 : axis;
}

}  // namespace

std::optional<HungChain> hung_chain(const Problem& problem, const std::vector<double>& start) {
  const auto layout = std::find_if(layouts.begin(), layouts.end(),
                                   [&](const Layout& candidate) { return candidate.model == problem.model; });
  if (layout == layouts.end()) {
    return std::nullopt;
  }
  const std::size_t coordinates = start.size() / 2;
  HungChain chain{
      std::vector<HungChain::Mass>(coordinates / layout->axes - layout->pinned), layout->far_end, problem.to, {}};
  for (std::size_t j = layout->pinned * layout->axes; j < coordinates; ++j) {
    HungChain::Mass& mass = chain.masses[j / layout->axes - layout->pinned];
    mass.position[axis_of(*layout, j)] = start[j];
    mass.velocity[axis_of(*layout, j)] = start[coordinates + j];
  }
  for (const Known& known : problem.end) {
    chain.watched.push_back(
        {known.component / layout->axes - layout->pinned, axis_of(*layout, known.component), known.value});
  }
  return chain;
}

std::string to_text(const HungChain& chain) {
  const auto numbers = [](const std::array<double, 3>& values) {
    return fmt::format(" {:.17g} {:.17g} {:.17g}", values[0], values[1], values[2]);
  };
  std::string text = fmt::format("to {:.17g}\n", chain.to);
  for (const HungChain::Mass& mass : chain.masses) {
    text += "mass" + numbers(mass.position) + numbers(mass.velocity) + "\n";
  }
  if (chain.far_end) {
    text += "far" + numbers(*chain.far_end) + "\n";
  }
  for (const HungChain::Watched& watched : chain.watched) {
    text += fmt::format("watch {} {} {:.17g}\n", watched.mass, watched.axis, watched.value);
  }
  return text;
}

}  // namespace bench::precision
