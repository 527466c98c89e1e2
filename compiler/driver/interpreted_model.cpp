#include "driver/interpreted_model.hpp"

#include <algorithm>

#include "diagnostics/assert.hpp"
#include "emit/emit.hpp"
#include "graph/evaluate.hpp"
#include "model/columns.hpp"

namespace mbcc {

using graph::Kind;
using graph::Node;
using program::NodeId;
using program::Store;
using program::Target;

static_assert(interface_version == mbrt::interface_version);

InterpretedModel::InterpretedModel(const program::Program& program, const model::System& system, const Sources& sources)
    : program_(program), coordinates_(system.coordinates.size()), values_(program.graph->size()) {
  for (NodeId id = 0; id < values_.size(); ++id) {
    const Node& node = (*program.graph)[id];
    switch (node.kind) {
      case Kind::Constant:
        values_[id] = node.value;
        break;
      case Kind::Parameter:
        parameter_leaves_.push_back({id, node.index});
        break;
      case Kind::Time:
        time_leaves_.push_back({id, 0});
        break;
      case Kind::Coordinate:
        component_leaves_.push_back({id, node.index});
        break;
      case Kind::Speed:
        component_leaves_.push_back({id, coordinates_ + node.index});
        break;
      case Kind::CoordinateChange:
        direction_leaves_.push_back({id, node.index});
        break;
      case Kind::SpeedChange:
        direction_leaves_.push_back({id, coordinates_ + node.index});
        break;
      case Kind::Acceleration:
        rate_leaves_.push_back({id, coordinates_ + node.index});
        break;
      default:  // applications, and leaves of series, which are not interpreted
        break;
    }
  }
  for (const program::IslandIndices& island : program.islands) {
    const std::size_t m = island.constraints.size();
    const std::size_t n = island.speeds.size();
    IslandArrays arrays;
    for (auto* per_row : {&arrays.scale, &arrays.floor, &arrays.residual, &arrays.position, &arrays.velocity}) {
      per_row->resize(m);
    }
    for (auto* per_speed : {&arrays.free, &arrays.mobility, &arrays.added}) {
      per_speed->resize(n);
    }
    arrays.matrix.resize(m * n);
    arrays.scratch.resize(mbrt::scratch_size(m, n));
    arrays.record.rank = static_cast<int>(m);
    islands_.push_back(std::move(arrays));
  }
  describe(system, sources);
  prepare();
}

void InterpretedModel::describe(const model::System& system, const Sources& sources) {
  const auto keep = [this](std::string text) { return texts_.emplace_back(std::move(text)).c_str(); };
  for (const model::Coordinate& coordinate : system.coordinates) {
    coordinate_names_.push_back(keep(coordinate.name));
  }
  for (const model::Speed& speed : system.speeds) {
    speed_names_.push_back(keep(speed.name));
    acceleration_names_.push_back(keep(speed.acceleration));
  }
  for (const model::Output& output : system.outputs) {
    output_names_.push_back(keep(output.name));
  }
  for (const model::Parameter& parameter : system.parameters) {
    parameter_entries_.push_back({keep(parameter.name), parameter.value});
    parameters_.push_back(parameter.value);
  }
  for (const model::Constraint& constraint : system.constraints) {
    constraint_entries_.push_back({keep(constraint.name), keep(sources.place(constraint.span)), constraint.holonomic});
  }
  for (const model::Force& force : system.forces) {
    force_entries_.push_back({keep(force.name), keep(sources.place(force.span))});
  }
  const auto as_ints = [this](const std::vector<std::size_t>& indices) -> std::span<const int> {
    return indices_.emplace_back(indices.begin(), indices.end());
  };
  for (const program::IslandIndices& island : program_.islands) {
    island_entries_.push_back({as_ints(island.constraints), as_ints(island.speeds)});
  }
  const model::Integration& given = system.integration;
  const mbrt::Defaults defaults{given.from.value_or(mbrt::not_given),  given.to.value_or(mbrt::not_given),
                                given.step.value_or(mbrt::not_given),  given.tolerance.value_or(mbrt::not_given),
                                given.every.value_or(mbrt::not_given), given.method ? keep(*given.method) : nullptr};
  description_ = {keep(system.name),
                  keep(std::string(version)),
                  coordinate_names_,
                  speed_names_,
                  acceleration_names_,
                  output_names_,
                  parameter_entries_,
                  constraint_entries_,
                  force_entries_,
                  island_entries_,
                  program_.energy.sections.front().has_stores(),
                  false,
                  defaults,
                  indices_.emplace_back(model::columns(system)),
                  program_.tangent.has_value()};
}

void InterpretedModel::load(const std::vector<Leaf>& leaves, std::span<const double> values) {
  for (const Leaf& leaf : leaves) {
    values_[leaf.node] = values[leaf.index];
  }
}

/// `put(store, value)` takes each stored value.
template <class Put>
void InterpretedModel::execute(const program::Section& section, const Put& put) {
  for (const program::Unit& unit : section.units) {
    for (const NodeId id : unit.order) {
      const Node& node = (*program_.graph)[id];
      std::array<const double*, 3> operands{};
      for (std::size_t i = 0; i < node.used_operands().size(); ++i) {
        operands[i] = &values_[node.operands[i]];
      }
      values_[id] = graph::perform(node.op, operands);
    }
    for (const Store& store : unit.stores) {
      put(store, values_[store.value]);
    }
  }
}

template <class Put>
void InterpretedModel::execute(const program::Kernel& kernel, const Put& put) {
  for (const program::Section& section : kernel.sections) {
    execute(section, put);
  }
}

/// Whether every pivot is safe, after the solve has been executed: `holds(guard)` says it of one.
template <class Holds>
bool InterpretedModel::guards_hold(const program::IslandSolve& island, const Holds& holds) const {
  return std::all_of(island.solve.units.begin(), island.solve.units.end(), [&](const program::Unit& unit) {
    return std::all_of(unit.guards.begin(), unit.guards.end(), holds);
  });
}

void InterpretedModel::prepare() {
  load(parameter_leaves_, parameters_);
  execute(program_.prepare, [](const Store&, double) {});
}

InterpretedModel::State InterpretedModel::initial_state() {
  State y(coordinates_ + speed_names_.size());
  load(parameter_leaves_, parameters_);
  execute(program_.initial, [&](const Store& store, double value) { y[store.index] = value; });
  return y;
}

void InterpretedModel::set_time(double time) {
  for (const Leaf& leaf : time_leaves_) {
    values_[leaf.node] = time;
  }
  execute(program_.time, [](const Store&, double) {});
}

void InterpretedModel::rates(const State& y, State& rate) {
  load(component_leaves_, y);
  execute(program_.rates, [&](const Store& store, double value) { rate[store.index] = value; });
  for (const program::IslandSolve& island : program_.rates.islands) {
    solve(island, y, rate);
  }
}

void InterpretedModel::solve(const program::IslandSolve& island, const State& y, State& rate) {
  execute(island.solve, [&](const Store& store, double value) { rate[store.index] = value; });
  IslandArrays& arrays = islands_[island.island];
  const auto holds = [&](const program::Guard& guard) {
    return mbrt::holds(values_[guard.pivot], values_[guard.diagonal], arrays.floor[guard.row] * values_[guard.scale],
                       arrays.floor.size());
  };
  if (!island.always_climbs && guards_hold(island, holds)) {
    return;
  }
  island_rows(static_cast<int>(island.island), y);
  mbrt::climb(this->island(static_cast<int>(island.island)), arrays.added);
  const std::vector<std::size_t>& speeds = program_.islands[island.island].speeds;
  for (std::size_t j = 0; j < speeds.size(); ++j) {
    rate[coordinates_ + speeds[j]] = arrays.free[j] + arrays.added[j];
  }
  if (program_.couple.sections.front().has_stores()) {
    std::vector<double> coupled(speed_names_.size());
    couple(y, rate, coupled);
    for (const std::size_t speed : speeds) {
      rate[coordinates_ + speed] = coupled[speed];
    }
  }
}

bool InterpretedModel::tangent(const State& y, const State& direction, State& change) {
  if (!program_.tangent) {
    return false;
  }
  load(component_leaves_, y);
  load(direction_leaves_, direction);
  const auto put = [&](const Store& store, double value) { change[store.index] = value; };
  execute(*program_.tangent, put);
  return std::all_of(program_.tangent->islands.begin(), program_.tangent->islands.end(),
                     [&](const program::IslandSolve& island) {
                       execute(island.solve, put);
                       const std::vector<double>& floor = islands_[island.island].floor;
                       return !island.always_climbs && guards_hold(island, [&](const program::Guard& guard) {
                         return mbrt::nearly_holds(values_[guard.pivot], values_[guard.diagonal],
                                                   floor[guard.row] * values_[guard.scale]);
                       });
                     });
}

mbrt::Island InterpretedModel::island(int island) {
  IslandArrays& arrays = islands_[static_cast<std::size_t>(island)];
  return {arrays.scale,
          arrays.floor,
          arrays.scratch,
          {arrays.matrix, arrays.residual, arrays.free, arrays.mobility, arrays.position, arrays.velocity},
          &arrays.record};
}

void InterpretedModel::island_rows(int island, const State& y) {
  load(component_leaves_, y);
  const mbrt::IslandRows rows = this->island(island).rows;
  rows.clear();
  execute(program_.island_rows[static_cast<std::size_t>(island)], [&](const Store& store, double value) {
    switch (store.target) {
      case Target::Matrix:
        rows.matrix[store.index] = value;
        break;
      case Target::Residual:
        rows.residual[store.index] = value;
        break;
      case Target::Free:
        rows.free[store.index] = value;
        break;
      case Target::RowPosition:
        rows.position[store.index] = value;
        break;
      case Target::RowVelocity:
        rows.velocity[store.index] = value;
        break;
      default:
        MBCC_ASSERT(store.target == Target::Mobility);
        rows.mobility[store.index] = value;
    }
  });
}

void InterpretedModel::constraint_errors(const State& y, const State& rate, std::span<double> position,
                                         std::span<double> velocity, std::span<double> acceleration) {
  load(component_leaves_, y);
  load(rate_leaves_, rate);
  execute(program_.constraint_errors, [&](const Store& store, double value) {
    (store.target == Target::Position   ? position
     : store.target == Target::Velocity ? velocity
                                        : acceleration)[store.index] = value;
  });
}

/// `shift` begins as a copy of what `rate` has in the place of the speeds.
void InterpretedModel::shift(const program::Kernel& kernel, const State& y, const State& rate,
                             std::span<double> shift) {
  load(component_leaves_, y);
  load(rate_leaves_, rate);
  for (std::size_t j = 0; j < std::min(shift.size(), rate.size() - coordinates_); ++j) {
    shift[j] = rate[coordinates_ + j];
  }
  execute(kernel, [&](const Store& store, double value) { shift[store.index] = value; });
}

void InterpretedModel::couple(const State& y, const State& rate, std::span<double> shift) {
  this->shift(program_.couple, y, rate, shift);
}

void InterpretedModel::uncouple(const State& y, const State& rate, std::span<double> shift) {
  this->shift(program_.uncouple, y, rate, shift);
}

void InterpretedModel::move(const State& y, const State& rate, std::span<double> shift) {
  this->shift(program_.move, y, rate, shift);
}

double InterpretedModel::energy(const State& y) {
  load(component_leaves_, y);
  double energy = 0;
  execute(program_.energy, [&](const Store&, double value) { energy = value; });
  return energy;
}

void InterpretedModel::outputs(const State& y, const State& rate, std::span<double> values) {
  load(component_leaves_, y);
  load(rate_leaves_, rate);
  execute(program_.outputs, [&](const Store& store, double value) { values[store.index] = value; });
}

void InterpretedModel::applied_forces(const State& y, std::span<double> values) {
  load(component_leaves_, y);
  execute(program_.applied_forces, [&](const Store& store, double value) { values[store.index] = value; });
}

}  // namespace mbcc
