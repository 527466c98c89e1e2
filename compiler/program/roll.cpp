#include "program/roll.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>

namespace mbcc::program {

namespace {

using graph::Graph;
using graph::Kind;
using graph::Node;

constexpr std::size_t longest_period = 6;
constexpr int shape_depth = 2;

std::uint64_t mix(std::uint64_t hash, std::uint64_t word) { return (std::rotl(hash, 23) ^ word) * 0x9E3779B97F4A7C15u; }

/// A unit without its indices: equal words, equal shape. Where the words speak of an index, `indices` has it.
struct Shape {
  std::vector<std::uint64_t> words;
  std::vector<long> indices;
};

/// Describes the units of a section so that they can be compared.
class Shapes {
 public:
  Shapes(const Section& section, const Graph& graph) : graph_(graph) {
    for (std::size_t u = 0; u < section.units.size(); ++u) {
      for (const NodeId id : section.units[u].order) {
        unit_of_[id] = u;
      }
    }
    for (const Unit& unit : section.units) {
      classify(unit);
    }
    for (std::size_t u = 0; u < section.units.size(); ++u) {
      shapes_.push_back(describe(section.units[u], u));
    }
  }

  const std::vector<Shape>& all() const { return shapes_; }
  const std::unordered_map<NodeId, Element>& elements() const { return elements_; }
  std::size_t arrays() const { return sizes_.size(); }
  long size(std::size_t array) const { return sizes_[array]; }

 private:
  /// Gives every value of the unit its class and its number in it.
  void classify(const Unit& unit) {
    std::map<std::uint64_t, std::uint64_t> occurrences;
    for (const NodeId id : unit.order) {
      const std::uint64_t shape = shape_of(id, shape_depth);
      const auto [found, is_new] = classes_.try_emplace({shape, occurrences[shape]++}, sizes_.size());
      if (is_new) {
        sizes_.push_back(0);
      }
      elements_[id] = {found->second, sizes_[found->second]++};
    }
  }

  std::uint64_t shape_of(NodeId id, int depth) const {
    const Node& node = graph_[id];
    const std::uint64_t kind = static_cast<std::uint64_t>(node.kind);
    if (node.kind == Kind::Constant) {
      return mix(kind, std::bit_cast<std::uint64_t>(node.value));
    }
    if (node.kind != Kind::Apply) {
      return mix(kind, 0);
    }
    if (!unit_of_.contains(id)) {
      return mix(kind, id);  // computed outside the section: the same one or another
    }
    std::uint64_t hash = mix(kind, static_cast<std::uint64_t>(node.op));
    for (const NodeId operand : node.used_operands()) {
      hash = mix(hash, depth == 0 ? 0 : shape_of(operand, depth - 1));
    }
    return hash;
  }

  Shape describe(const Unit& unit, std::size_t u) const {
    Shape shape;
    std::map<NodeId, std::uint64_t> positions;
    for (const NodeId id : unit.order) {
      shape.words.push_back(static_cast<std::uint64_t>(graph_[id].op));
      for (const NodeId operand : graph_[id].used_operands()) {
        refer(operand, u, positions, shape);
      }
      shape.words.push_back(elements_.at(id).array);
      shape.indices.push_back(elements_.at(id).index);
      positions.emplace(id, positions.size());
    }
    for (const Store& store : unit.stores) {
      shape.words.push_back(static_cast<std::uint64_t>(store.target));
      shape.indices.push_back(static_cast<long>(store.index));
      refer(store.value, u, positions, shape);
    }
    for (const Guard& guard : unit.guards) {
      shape.words.push_back(guard.diagonal == guard.pivot ? 1 : 0);
      shape.indices.push_back(static_cast<long>(guard.row));
      refer(guard.diagonal, u, positions, shape);
      refer(guard.pivot, u, positions, shape);
      refer(guard.scale, u, positions, shape);
    }
    return shape;
  }

  void refer(NodeId id, std::size_t u, const std::map<NodeId, std::uint64_t>& positions, Shape& shape) const {
    enum : std::uint64_t { Local, Published, Leaf, Scalar };
    const Node& node = graph_[id];
    const auto unit = unit_of_.find(id);
    if (unit != unit_of_.end() && unit->second == u) {
      shape.words.insert(shape.words.end(), {Local, positions.at(id)});
    } else if (unit != unit_of_.end()) {
      shape.words.insert(shape.words.end(), {Published, elements_.at(id).array});
      shape.indices.push_back(elements_.at(id).index);
    } else if (node.kind == Kind::Apply || node.kind == Kind::Constant) {
      shape.words.insert(shape.words.end(), {Scalar, id});
    } else {
      shape.words.insert(shape.words.end(), {Leaf, static_cast<std::uint64_t>(node.kind)});
      shape.indices.push_back(node.index);
    }
  }

  const Graph& graph_;
  std::unordered_map<NodeId, std::size_t> unit_of_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, std::size_t> classes_;
  std::vector<long> sizes_;
  std::unordered_map<NodeId, Element> elements_;
  std::vector<Shape> shapes_;
};

/// How many iterations of `period` units from `first` on have one shape and indices that move evenly.
std::size_t iterations_from(const std::vector<Shape>& shapes, std::size_t first, std::size_t period) {
  std::size_t iterations = 1;
  for (;; ++iterations) {
    for (std::size_t r = 0; r < period; ++r) {
      const std::size_t u = first + iterations * period + r;
      if (u >= shapes.size() || shapes[u].words != shapes[first + r].words) {
        return iterations;
      }
      const std::vector<long>& start = shapes[first + r].indices;
      const std::vector<long>& second = shapes[first + period + r].indices;
      for (std::size_t k = 0; k < start.size(); ++k) {
        if (shapes[u].indices[k] - start[k] != static_cast<long>(iterations) * (second[k] - start[k])) {
          return iterations;
        }
      }
    }
  }
}

Run longest_run(const std::vector<Shape>& shapes, std::size_t first) {
  Run best{first, 1, 1};
  for (std::size_t period = 1; period <= longest_period && first + period <= shapes.size(); ++period) {
    const std::size_t iterations = iterations_from(shapes, first, period);
    if (iterations * period >= shortest_run && iterations * period > best.iterations * best.period &&
        iterations > period) {
      best = {first, period, iterations};
    }
  }
  return best;
}

bool is_inside(std::size_t unit, const Run& run) {
  return unit >= run.first && unit < run.first + run.period * run.iterations;
}

/// Marks the arrays that have to exist: of values that cross the border of an iteration of a loop.
std::vector<bool> needed_arrays(const Section& section, const Graph& graph, const Shapes& shapes,
                                const std::vector<Run>& runs, const std::set<NodeId>& used_elsewhere) {
  std::vector<bool> needed(shapes.arrays());
  std::unordered_map<NodeId, std::pair<std::size_t, std::size_t>> made_in;  // run and iteration
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (std::size_t u = runs[r].first; is_inside(u, runs[r]); ++u) {
      for (const NodeId id : section.units[u].order) {
        made_in[id] = {r, (u - runs[r].first) / runs[r].period};
        if (runs[r].iterations > 1 && used_elsewhere.contains(id)) {
          needed[shapes.elements().at(id).array] = true;
        }
      }
    }
  }
  for (std::size_t r = 0; r < runs.size(); ++r) {
    for (std::size_t u = runs[r].first; is_inside(u, runs[r]); ++u) {
      const std::pair here{r, (u - runs[r].first) / runs[r].period};
      for_each_read(section.units[u], graph, [&](NodeId id) {
        const auto made = made_in.find(id);
        if (made != made_in.end() && made->second != here &&
            (runs[r].iterations > 1 || runs[made->second.first].iterations > 1)) {
          needed[shapes.elements().at(id).array] = true;
        }
      });
    }
  }
  return needed;
}

bool is_computed_in(NodeId node, const Section& section, std::size_t first, std::size_t period) {
  for (std::size_t u = first; u < first + period; ++u) {
    const std::vector<NodeId>& order = section.units[u].order;
    if (std::find(order.begin(), order.end(), node) != order.end()) {
      return true;
    }
  }
  return false;
}

/// The value of the first iteration whose element the second iteration reads where the first one reads `element`.
std::optional<NodeId> find_producer(const std::pair<const NodeId, Element>& element, long stride, const Run& run,
                                    const Section& section, const RolledSection& rolled) {
  const Element wanted{element.second.array, element.second.index + stride};
  for (std::size_t r = 0; r < run.period; ++r) {
    const std::vector<NodeId>& order = section.units[run.first + r].order;
    const std::vector<NodeId>& next = section.units[run.first + run.period + r].order;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const auto made = rolled.elements.find(order[k]);
      if (made != rolled.elements.end() && made->second.array == wanted.array && made->second.index == wanted.index &&
          rolled.elements.at(next[k]).index - made->second.index == stride) {
        return order[k];
      }
    }
  }
  return std::nullopt;
}

}  // namespace

std::set<NodeId> read_beyond_their_section(const std::vector<const Section*>& sections,
                                           const std::vector<NodeId>& provided, const Graph& graph) {
  std::unordered_map<NodeId, const Section*> made_in;
  for (const Section* section : sections) {
    for (const Unit& unit : section->units) {
      for (const NodeId id : unit.order) {
        made_in.emplace(id, section);
      }
    }
  }
  std::set<NodeId> shared(provided.begin(), provided.end());
  for (const Section* section : sections) {
    for (const Unit& unit : section->units) {
      for_each_read(unit, graph, [&](NodeId id) {
        const auto made = made_in.find(id);
        if (made != made_in.end() && made->second != section) {
          shared.insert(id);
        }
      });
    }
  }
  return shared;
}

RolledSection roll(const Section& section, const Graph& graph, const std::set<NodeId>& used_elsewhere) {
  RolledSection rolled;
  if (section.units.size() < shortest_run) {
    for (std::size_t u = 0; u < section.units.size(); ++u) {
      rolled.runs.push_back({u, 1, 1});
    }
    return rolled;
  }
  const Shapes shapes(section, graph);
  bool any_loop = false;
  for (std::size_t u = 0; u < section.units.size();) {
    const Run run = longest_run(shapes.all(), u);
    rolled.runs.push_back(run);
    any_loop |= run.iterations > 1;
    u += run.period * run.iterations;
  }
  if (!any_loop) {
    return rolled;
  }
  const std::vector<bool> needed = needed_arrays(section, graph, shapes, rolled.runs, used_elsewhere);
  for (const auto& [id, element] : shapes.elements()) {
    if (needed[element.array]) {
      rolled.elements.emplace(id, element);
    }
  }
  for (std::size_t array = 0; array < needed.size(); ++array) {
    rolled.array_sizes.push_back(needed[array] ? shapes.size(array) : 0);
  }
  return rolled;
}

Operand operand_of(NodeId node, NodeId next, const Run& run, const Section& section, const RolledSection& rolled,
                   const Graph& graph) {
  if (is_computed_in(node, section, run.first, run.period) &&
      is_computed_in(next, section, run.first + run.period, run.period)) {
    return {Operand::Kind::Same, node, 0, 0, 0, 0};
  }
  const auto element = rolled.elements.find(node);
  if (element != rolled.elements.end()) {
    const long first = element->second.index;
    const long stride = rolled.elements.at(next).index - first;
    const std::optional<NodeId> producer = find_producer(*element, stride, run, section, rolled);
    return {producer ? Operand::Kind::Carried : Operand::Kind::Element,
            node,
            producer.value_or(0),
            element->second.array,
            first,
            stride};
  }
  const Node& leaf = graph[node];
  if (leaf.kind == Kind::Apply || leaf.kind == Kind::Constant || is_scalar(leaf.kind)) {
    return {Operand::Kind::Scalar, node, 0, 0, 0, 0};
  }
  const long first = leaf.index;
  return {Operand::Kind::Leaf, node, 0, 0, first, static_cast<long>(graph[next].index) - first};
}

}  // namespace mbcc::program
