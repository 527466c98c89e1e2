#include "emit/kernel_writer.hpp"

#include <fmt/format.h>

#include <iterator>
#include <map>

#include "diagnostics/assert.hpp"

namespace mbcc::cpp {

namespace {

using graph::Kind;
using graph::Level;
using graph::Node;
using graph::NodeId;
using graph::Operator;
using program::IslandSolve;
using program::Kernel;
using program::Program;
using program::Section;
using program::Store;
using program::Target;

/// An expression that is used once is written where it is used, unless it is longer than this.
constexpr std::size_t longest_inline_text = 70;

/// The left side of the assignment that a store is.
std::string place_of(const Store& store) {
  switch (store.target) {
    case Target::Initial:
      return fmt::format("y[{}]", store.index);
    case Target::Rate:
      return fmt::format("rate[{}]", store.index);
    case Target::Matrix:
      return fmt::format("rows.matrix[{}]", store.index);
    case Target::Residual:
      return fmt::format("rows.residual[{}]", store.index);
    case Target::Free:
      return fmt::format("rows.free[{}]", store.index);
    case Target::Mobility:
      return fmt::format("rows.mobility[{}]", store.index);
    case Target::Position:
      return fmt::format("position[{}]", store.index);
    case Target::Velocity:
      return fmt::format("velocity[{}]", store.index);
    case Target::Acceleration:
      return fmt::format("acceleration[{}]", store.index);
    case Target::Output:
      return fmt::format("values[{}]", store.index);
    case Target::Force:
      return fmt::format("values[{}]", store.index);
    case Target::Energy:
      break;
  }
  MBCC_ASSERT(store.target != Target::Energy);
  return {};
}

class KernelWriter {
 public:
  KernelWriter(const Kernel& kernel, const Program& program, const Naming& naming, std::size_t coordinates)
      : kernel_(kernel), program_(program), naming_(naming), coordinates_(coordinates), scope_(naming.scope) {
    for (const Section& section : kernel.sections) {
      count_uses(section);
    }
    for (const IslandSolve& island : kernel.islands) {
      for (const program::Guard& guard : island.guards) {
        use(guard.diagonal);
        use(guard.pivot);
      }
      count_uses(island.solve);
    }
  }

  Body write(const Comments& comments) {
    unpack_leaves();
    for (std::size_t i = 0; i < kernel_.sections.size(); ++i) {
      comment(i < comments.sections.size() ? comments.sections[i] : "");
      write_section(kernel_.sections[i]);
    }
    for (std::size_t i = 0; i < kernel_.islands.size(); ++i) {
      comment(comments.islands[i]);
      write_island(kernel_.islands[i]);
    }
    for (const NodeId id : kernel_.provides) {
      body_.text += fmt::format("{} = {};\n", naming_.members.at(id), text_of(id).text);
    }
    return std::move(body_);
  }

 private:
  void use(NodeId id) { ++uses_[id]; }

  void count_uses(const Section& section) {
    for (const NodeId id : section.order) {
      for (const NodeId operand : (*program_.graph)[id].used_operands()) {
        use(operand);
      }
    }
    for (const Store& store : section.stores) {
      use(store.value);
    }
  }

  /// sin and cos of one argument that one section needs are computed together.
  void find_pairs(const Section& section) {
    sines_.clear();
    cosines_.clear();
    for (const NodeId id : section.order) {
      const Node& node = (*program_.graph)[id];
      if (node.op == Operator::Sin) {
        sines_[node.operands[0]] = id;
      } else if (node.op == Operator::Cos) {
        cosines_[node.operands[0]] = id;
      }
    }
  }

  void unpack_leaves() {
    std::map<std::pair<Kind, std::uint32_t>, NodeId> leaves;
    for (const auto& [id, count] : uses_) {
      const Node& node = (*program_.graph)[id];
      if (node.kind != Kind::Apply && node.kind != Kind::Constant) {
        leaves.emplace(std::pair{node.kind, node.index}, id);
      }
    }
    for (const auto& [leaf, id] : leaves) {
      const auto [kind, index] = leaf;
      const bool is_component = kind == Kind::Coordinate || kind == Kind::Speed;
      body_.reads_state |= is_component;
      body_.reads_rate |= kind == Kind::Acceleration;
      codes_[id] = {name_of_leaf(kind, index), Binding::Primary};
      if (kind == Kind::Time) {
        body_.text += kernel_.level == Level::Time ? "" : "const double t = t_;\n";
        continue;
      }
      body_.text += fmt::format("const double {} = {};\n", codes_[id].text, source_of_leaf(kind, index));
    }
  }

  std::string name_of_leaf(Kind kind, std::uint32_t index) const {
    switch (kind) {
      case Kind::Coordinate:
        return naming_.coordinates[index];
      case Kind::Speed:
        return naming_.speeds[index];
      case Kind::Acceleration:
        return naming_.accelerations[index];
      case Kind::Parameter:
        return naming_.parameters[index];
      default:
        return "t";
    }
  }

  std::string source_of_leaf(Kind kind, std::uint32_t index) const {
    switch (kind) {
      case Kind::Coordinate:
        return fmt::format("y[{}]", index);
      case Kind::Speed:
        return fmt::format("y[{}]", coordinates_ + index);
      case Kind::Acceleration:
        return fmt::format("rate[{}]", coordinates_ + index);
      default:
        return fmt::format("parameters_[{}]", index);
    }
  }

  void comment(const std::string& lines) {
    if (lines.empty()) {
      return;
    }
    body_.text += body_.text.empty() ? "" : "\n";
    std::size_t begin = 0;
    while (begin < lines.size()) {
      const std::size_t end = std::min(lines.find('\n', begin), lines.size());
      body_.text += "// " + lines.substr(begin, end - begin) + "\n";
      begin = end + 1;
    }
  }

  void write_section(const Section& section) {
    find_pairs(section);
    for (const NodeId id : section.order) {
      compute(id);
    }
    for (const Store& store : section.stores) {
      const std::string value = text_of(store.value).text;
      body_.text += store.target == Target::Energy ? fmt::format("return {};\n", value)
                                                   : fmt::format("{} = {};\n", place_of(store), value);
    }
  }

  void write_island(const IslandSolve& island) {
    const std::size_t number = island.island + 1;
    if (island.always_climbs) {
      body_.text += fmt::format("climb_{}(y, rate);\n", number);
      body_.reads_state = true;
      return;
    }
    write_section(island.solve);
    if (island.guards.empty()) {
      return;
    }
    // One flag and one branch: the pivot tests then cost next to nothing.
    const std::string flag = scope_.declare("safe");
    std::string_view assignment = "bool {} = ";
    for (const program::Guard& guard : island.guards) {
      const std::string floor = fmt::format("island_{}_.floor({})", number, guard.row);
      const std::string pivot = text_of(guard.pivot).text;
      body_.text += fmt::format(fmt::runtime(assignment), flag);
      body_.text += guard.diagonal == guard.pivot
                        ? fmt::format("{} >= {};\n", pivot, floor)
                        : fmt::format("mbrt::holds({}, {}, {});\n", pivot, text_of(guard.diagonal).text, floor);
      assignment = "{} &= ";
    }
    body_.text += fmt::format("if (!{}) [[unlikely]] {{\n  climb_{}(y, rate);\n}}\n", flag, number);
    body_.reads_state = true;
  }

  /// Gives `id` its code: a line of its own if it is used more than once, has a name in the model, or is long.
  void compute(NodeId id) {
    if (codes_.contains(id)) {
      return;
    }
    const Node& node = (*program_.graph)[id];
    if (write_pair(node)) {
      return;
    }
    std::vector<Code> operands;
    for (const NodeId operand : node.used_operands()) {
      operands.push_back(text_of(operand));
    }
    const Code code = compose(node.op, operands);
    if (uses_[id] > 1 || program_.names.contains(id) || code.text.size() > longest_inline_text) {
      const std::string name = declare(id);
      body_.text += fmt::format("const double {} = {};\n", name, code.text);
      codes_[id] = {name, Binding::Primary};
    } else {
      codes_[id] = code;
    }
  }

  /// sin and cos of one argument with one call, if the kernel needs both.
  bool write_pair(const Node& node) {
    if (node.op != Operator::Sin && node.op != Operator::Cos) {
      return false;
    }
    const auto sine = sines_.find(node.operands[0]);
    const auto cosine = cosines_.find(node.operands[0]);
    if (sine == sines_.end() || cosine == cosines_.end()) {
      return false;
    }
    const std::string sine_name = declare(sine->second);
    const std::string cosine_name = declare(cosine->second);
    body_.text += fmt::format("const auto [{}, {}] = mbrt::sincos({});\n", sine_name, cosine_name,
                              text_of(node.operands[0]).text);
    codes_[sine->second] = {sine_name, Binding::Primary};
    codes_[cosine->second] = {cosine_name, Binding::Primary};
    return true;
  }

  std::string declare(NodeId id) {
    const auto named = program_.names.find(id);
    if (named != program_.names.end()) {
      return scope_.declare(named->second);
    }
    const Node& node = (*program_.graph)[id];
    return scope_.enumerate(node.op == Operator::Sin ? "s" : node.op == Operator::Cos ? "c" : "e");
  }

  Code text_of(NodeId id) const {
    const auto found = codes_.find(id);
    if (found != codes_.end()) {
      return found->second;
    }
    const Node& node = (*program_.graph)[id];
    if (node.kind == Kind::Constant) {
      return literal(node.value);
    }
    const auto member = naming_.members.find(id);
    MBCC_ASSERT(member != naming_.members.end());
    return {member->second, Binding::Primary};
  }

  const Kernel& kernel_;
  const Program& program_;
  const Naming& naming_;
  std::size_t coordinates_;
  Scope scope_;
  Body body_;
  std::map<NodeId, int> uses_;
  std::map<NodeId, NodeId> sines_, cosines_;  ///< of the section being written, by argument
  std::unordered_map<NodeId, Code> codes_;
};

}  // namespace

Naming make_naming(const model::System& system, const Program& program) {
  Naming naming;
  for (const model::Coordinate& coordinate : system.coordinates) {
    naming.coordinates.push_back(naming.scope.declare(coordinate.name));
  }
  for (const model::Speed& speed : system.speeds) {
    naming.speeds.push_back(naming.scope.declare(speed.name));
    naming.accelerations.push_back(naming.scope.declare(speed.acceleration));
  }
  for (const model::Parameter& parameter : system.parameters) {
    naming.parameters.push_back(naming.scope.declare(parameter.name));
  }
  for (const Kernel* kernel : {&program.prepare, &program.time}) {
    for (const NodeId id : kernel->provides) {
      const auto named = program.names.find(id);
      const std::string name = named != program.names.end()
                                   ? naming.scope.declare(named->second)
                                   : naming.scope.enumerate(kernel == &program.time ? "t" : "p");
      naming.members.emplace(id, name + "_");
    }
  }
  naming.keeps_time = program.keeps_time;
  return naming;
}

Body write_kernel(const Kernel& kernel, const Program& program, const Naming& naming, std::size_t coordinates,
                  const Comments& comments) {
  return KernelWriter(kernel, program, naming, coordinates).write(comments);
}

}  // namespace mbcc::cpp
