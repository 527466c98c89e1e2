#pragma once
// The Program: what the emitted class computes, as kernels over one lowered graph. Every value is computed at its own
// level and in no kernel that does not need it.

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "graph/graph.hpp"

namespace mbcc::program {

using graph::Level;
using graph::NodeId;

/// The runtime's function of the same name (mbrt/island.hpp): pivots that are known when compiling are judged by it.
constexpr double plain_pivot_ratio(std::size_t rows) { return rows > 2 ? 1e-3 : 1e-4; }

/// Where a kernel puts a value.
enum class Target {
#define MBCC_TARGET(name, meaning) name,
#include "program/targets.def"
};

constexpr const char* name_of(Target target) {
  constexpr std::array names = {
#define MBCC_TARGET(name, meaning) #name,
#include "program/targets.def"
  };
  return names[static_cast<std::size_t>(target)];
}

struct Store {
  Target target;
  std::size_t index;
  NodeId value;
};

/// The condition on which the plain solve of an island stands: pivot >= max(plain_pivot_ratio * diagonal, floor *
/// scale).
struct Guard {
  std::size_t row;  ///< within the island; the floor is its
  NodeId diagonal;
  NodeId pivot;
  NodeId scale;
};

/// A few values that belong together, such as all that one constraint needs: computations in order, then what is done
/// with them. Large scenes are made of many units of one shape, which become loops: roll.hpp.
struct Unit {
  std::vector<NodeId> order;  ///< every node to compute, operands first; no leaves, nothing of a lower level
  std::vector<Store> stores;
  std::vector<Guard> guards;  ///< only in the solve of an island
};

/// Calls `visit` with every value that a unit reads, leaves and constants included.
template <class Visit>
void for_each_read(const Unit& unit, const graph::Graph& graph, const Visit& visit) {
  for (const NodeId id : unit.order) {
    for (const NodeId operand : graph[id].used_operands()) {
      visit(operand);
    }
  }
  for (const Store& store : unit.stores) {
    visit(store.value);
  }
  for (const Guard& guard : unit.guards) {
    visit(guard.diagonal);
    visit(guard.pivot);
    visit(guard.scale);
  }
}

/// Units of one purpose, in order.
struct Section {
  std::vector<Unit> units;

  bool has_stores() const {
    return std::any_of(units.begin(), units.end(), [](const Unit& unit) { return !unit.stores.empty(); });
  }
  bool has_guards() const {
    return std::any_of(units.begin(), units.end(), [](const Unit& unit) { return !unit.guards.empty(); });
  }
};

/// What an island is solved for.
enum class Unknowns { Accelerations, Displacements, SpeedChanges, Tangents };

/// The unknowns of one island: `solve`, and the rest of the rank ladder instead if a guard does not hold. Without
/// guards the pivots are constant and safe.
struct IslandSolve {
  std::size_t island;
  Unknowns unknowns = Unknowns::Accelerations;
  Section solve;               ///< rows, pivots, multipliers, unknowns
  bool always_climbs = false;  ///< more rows than speeds, or pivots constant and not safe: no solve
  bool refuses = false;        ///< rather than climb, the kernel gives up
};

struct Kernel {
  Level level = Level::State;
  std::vector<Section> sections;
  std::vector<IslandSolve> islands;  ///< after the sections; in `rates`, tangents, the shifts and the start of a series
  std::vector<NodeId> provides;      ///< values that kernels of higher levels read
};

/// The pass through the recurrences of a Taylor series: Note [series] in series_plan.hpp.
struct SeriesKernels {
  Kernel start;  ///< of level State: what all orders read, and the guards of the factorisation
  Kernel fast;   ///< the rest of level Order
  Kernel slow;
  Kernel solve;
  std::size_t products = 0;  ///< lanes
  std::size_t slow_products = 0;
  std::size_t squares = 0;
  std::size_t slow_squares = 0;
  std::size_t switches = 0;
};

/// Rows (constraints) in elimination order and speeds of an island, as indices into the System's.
struct IslandIndices {
  std::vector<std::size_t> constraints;
  std::vector<std::size_t> speeds;
};

struct Program {
  std::unique_ptr<graph::Graph> graph = std::make_unique<graph::Graph>();  ///< lowered: Note [lowering] in lower.hpp
  std::unordered_map<NodeId, std::string> names;  ///< what a value is, where the model knows: "d_sphere"
  std::vector<IslandIndices> islands;
  bool keeps_time = false;  ///< whether a kernel of level State reads t itself

  Kernel initial;  ///< of parameters
  Kernel prepare;  ///< what depends on parameters alone and is needed later: no stores
  Kernel time;     ///< likewise on time
  Kernel rates;
  Kernel position_shifts;  ///< onto the constraints, where runs project: else, and without constraints, empty
  Kernel velocity_shifts;
  std::vector<Kernel> island_rows;  ///< one per island
  Kernel couple;    ///< speeds' changes from those of uncoupled ones, where any are coupled; reads them as u'
  Kernel uncouple;  ///< the other way round
  Kernel move;      ///< coordinates' displacements from those along speeds, where they are not the same; likewise
  Kernel constraint_errors;
  Kernel energy;  ///< without stores where the energy is not known
  Kernel outputs;
  Kernel applied_forces;
  std::optional<SeriesKernels> series;  ///< where a method wants it
  std::optional<Kernel> tangent;        ///< likewise
};

}  // namespace mbcc::program
