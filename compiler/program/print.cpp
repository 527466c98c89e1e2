#include "mechanics/print.hpp"

#include <fmt/format.h>

#include "program/schedule.hpp"

namespace mbcc {

namespace program {

namespace {

/// Prints kernels as lists of numbered operations.
class Printer {
 public:
  Printer(const Program& program, const model::System& system)
      : program_(program), leaf_name_(mechanics::leaf_names(system)) {}

  void kernel(std::string_view name, const Kernel& kernel) {
    text += fmt::format("kernel {}\n", name);
    for (const Section& part : kernel.sections) {
      section(part, "  ");
    }
    for (const NodeId id : kernel.provides) {
      text += fmt::format("  provide {}\n", reference(id));
    }
    for (const IslandSolve& island : kernel.islands) {
      text += fmt::format("  island {}{}\n", island.island + 1, island.always_climbs ? " climbs always" : "");
      section(island.solve, "    ");
    }
  }

  std::string text;

 private:
  void section(const Section& section, std::string_view indentation) {
    for (const Unit& part : section.units) {
      unit(part, indentation);
    }
  }

  void unit(const Unit& unit, std::string_view indentation) {
    for (const NodeId id : unit.order) {
      const graph::Node& node = (*program_.graph)[id];
      std::string operands;
      for (const NodeId operand : node.used_operands()) {
        operands += " " + reference(operand);
      }
      const auto name = program_.names.find(id);
      text += fmt::format("{}%{} = {}{}{}\n", indentation, id, graph::row(node.op).name, operands,
                          name == program_.names.end() ? "" : "   # " + name->second);
    }
    for (const Store& store : unit.stores) {
      text += fmt::format("{}{}[{}] <- {}\n", indentation, name_of(store.target), store.index, reference(store.value));
    }
    for (const Guard& guard : unit.guards) {
      text += fmt::format("{}guard {} against {} scaled by {}\n", indentation, reference(guard.pivot),
                          reference(guard.diagonal), reference(guard.scale));
    }
  }

  std::string reference(NodeId id) const {
    const graph::Node& node = (*program_.graph)[id];
    switch (node.kind) {
      case graph::Kind::Constant:
        return fmt::format("{}", node.value);
      case graph::Kind::Apply:
        return fmt::format("%{}", id);
#define MBCC_SERIES_LEAF(name, meaning) \
  case graph::Kind::name:               \
    return fmt::format("{}[{}]", #name, node.index);
#include "graph/series_leaves.def"
      default:
        return leaf_name_(node);
    }
  }

  const Program& program_;
  graph::LeafName leaf_name_;
};

}  // namespace

}  // namespace program

std::string print(const program::Program& program, const model::System& system) {
  program::Printer printer(program, system);
  printer.kernel("initial", program.initial);
  printer.kernel("prepare", program.prepare);
  printer.kernel("time", program.time);
  printer.kernel("rates", program.rates);
  if (!program.velocity_shifts.islands.empty()) {
    printer.kernel("position_shifts", program.position_shifts);
    printer.kernel("velocity_shifts", program.velocity_shifts);
  }
  for (std::size_t i = 0; i < program.island_rows.size(); ++i) {
    printer.kernel(fmt::format("rows of island {}", i + 1), program.island_rows[i]);
  }
  if (program.series) {
    printer.kernel("series, start", program.series->start);
    printer.kernel("series, fast lanes of an order", program.series->fast);
    printer.kernel("series, slow lanes of an order", program.series->slow);
    printer.kernel("series, solve of an order", program.series->solve);
  }
  if (program.tangent) {
    printer.kernel("tangent", *program.tangent);
  }
  printer.kernel("constraint_errors", program.constraint_errors);
  printer.kernel("energy", program.energy);
  printer.kernel("outputs", program.outputs);
  printer.kernel("applied_forces", program.applied_forces);
  return std::move(printer.text);
}

}  // namespace mbcc
