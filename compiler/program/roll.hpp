#pragma once
// Note [rolling]: large scenes repeat themselves. The units of a chain's links, of a net's rods, of the pivots of a
// long elimination have one shape and differ in indices alone; written out they are half a megabyte that no
// instruction cache holds. Rolling finds runs of units of one shape, whose every index moves by a constant stride from
// one iteration to the next, and makes them loops. Nothing else changes: the same operations in the same order.
//
// Units are compared after their values have been put into classes: values of one shape (the operations at the top of
// the expression) at one position among their like in the unit. The values of a class are numbered in order, and where
// a loop reads a value that it did not just compute, it reads an array over the class.
//
// Scenes of up to `shortest_run` units of a shape stay straight-line: there that is faster (measured on chains).

#include <set>
#include <unordered_map>
#include <vector>

#include "program/program.hpp"

namespace mbcc::program {

inline constexpr std::size_t shortest_run = 16;

/// `period` units from `first` on, `iterations` times; a single iteration is written out.
struct Run {
  std::size_t first;
  std::size_t period;
  std::size_t iterations;
};

/// The element of the array of a class that holds a value.
struct Element {
  std::size_t array;
  long index;
};

struct RolledSection {
  std::vector<Run> runs;                         ///< every unit, in order
  std::unordered_map<NodeId, Element> elements;  ///< of values that have one
  std::vector<long> array_sizes;                 ///< 0 where no loop needs the array
};

/// Values that one of a kernel's sections computes and another one reads, or a later kernel, to which they are
/// provided.
std::set<NodeId> read_beyond_their_section(const std::vector<const Section*>& sections,
                                           const std::vector<NodeId>& provided, const graph::Graph& graph);

/// `used_elsewhere` are the values that other sections read.
RolledSection roll(const Section& section, const graph::Graph& graph, const std::set<NodeId>& used_elsewhere);

/// What an operand is, in every iteration of a run.
struct Operand {
  enum class Kind {
    Same,     ///< computed in the same iteration
    Carried,  ///< an element that the iteration before computed, as its value that is now `producer`
    Element,  ///< an element of an array: `array`, index `first` + i * `stride`
    Leaf,     ///< a component or parameter: `first` + i * `stride`
    Scalar,   ///< the same value in every iteration
  };
  Kind kind;
  NodeId node;  ///< in the first iteration
  NodeId producer = 0;
  std::size_t array = 0;
  long first = 0;
  long stride = 0;
};

/// `node` as read in the first iteration of `run`, `next` the value read at the same place of the second one.
Operand operand_of(NodeId node, NodeId next, const Run& run, const Section& section, const RolledSection& rolled,
                   const graph::Graph& graph);

}  // namespace mbcc::program
