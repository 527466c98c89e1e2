#include "emit/kernel_writer.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "diagnostics/assert.hpp"
#include "emit/code.hpp"
#include "emit/targets.hpp"
#include "program/roll.hpp"

namespace mbcc::cpp {

namespace {

using graph::Kind;
using graph::Level;
using graph::Node;
using graph::NodeId;
using graph::Operator;
using program::Guard;
using program::IslandSolve;
using program::Kernel;
using program::Operand;
using program::Program;
using program::RolledSection;
using program::Run;
using program::Section;
using program::Store;
using program::Target;
using program::Unit;

/// An expression that is used once is written where it is used, unless it is longer than this.
constexpr std::size_t longest_inline_text = 70;

class KernelWriter {
 public:
  KernelWriter(const Kernel& kernel, const Program& program, const Naming& naming)
      : kernel_(kernel), program_(program), graph_(*program.graph), naming_(naming), scope_(naming.scope.nested()) {
    for (const Section& section : kernel.sections) {
      sections_.push_back(&section);
    }
    for (const IslandSolve& island : kernel.islands) {
      sections_.push_back(&island.solve);
    }
    roll_sections();
    count_uses();
  }

  Body write(const Comments& comments) {
    unpack_leaves();
    i_ = scope_.declare("i");
    const std::size_t plain = kernel_.sections.size();
    for (std::size_t s = 0; s < sections_.size(); ++s) {
      const std::vector<std::string>& list = s < plain ? comments.sections : comments.islands;
      const std::size_t at = s < plain ? s : s - plain;
      comment(at < list.size() ? list[at] : "");
      if (s < plain) {
        write_section(*sections_[s], rolled_[s]);
      } else {
        write_island(kernel_.islands[at], rolled_[s]);
      }
    }
    if (kernel_.level < Level::State) {
      for (const NodeId id : kernel_.provides) {
        line(fmt::format("{} = {};", naming_.members.at(id), code_of(id).text));
      }
    }
    return std::move(body_);
  }

  /// After write(): the names of what stands in the function by now.
  Naming within() const {
    Naming naming = naming_;
    naming.scope = scope_;
    for (const auto& [leaf, id] : unpacked_leaves_) {
      naming.members[id] = codes_.at(id).text;
    }
    for (const NodeId id : kernel_.provides) {
      naming.members[id] = code_of(id).text;
    }
    return naming;
  }

 private:
  void roll_sections() {
    const std::set<NodeId> shared = program::read_beyond_their_section(sections_, kernel_.provides, graph_);
    for (const Section* section : sections_) {
      rolled_.push_back(program::roll(*section, graph_, shared));
    }
  }

  /// Counts what is written out: of a loop that is its first iteration.
  void count_uses() {
    for (std::size_t s = 0; s < sections_.size(); ++s) {
      for (const Run& run : rolled_[s].runs) {
        const bool is_loop = run.iterations > 1;
        for (std::size_t u = run.first; u < run.first + run.period; ++u) {
          program::for_each_read(sections_[s]->units[u], graph_, [&](NodeId id) {
            ++uses_[id];
            const Kind kind = graph_[id].kind;
            body_.reads_state |= kind == Kind::Coordinate || kind == Kind::Speed;
            body_.reads_rate |= kind == Kind::Acceleration;
            if (is_unpacked(kind, is_loop) && !naming_.members.contains(id)) {
              unpacked_leaves_.emplace(std::pair{kind, graph_[id].index}, id);
            }
          });
        }
      }
    }
    for (const NodeId id : kernel_.provides) {
      uses_[id] += kernel_.level < Level::State ? 1 : 2;  // what is local is worth a name
    }
  }

  /// Scalars have a name of their own everywhere, components of the state outside of loops, rows of series nowhere.
  static bool is_unpacked(Kind kind, bool in_loop) {
    return is_scalar(kind) || (kind > Kind::Constant && kind <= Kind::Acceleration && !in_loop);
  }

  void unpack_leaves() {
    for (const auto& [leaf, id] : unpacked_leaves_) {
      const auto [kind, index] = leaf;
      codes_[id] = {naming_.name_of_leaf(kind, index), Binding::Primary};
      if (kind != Kind::Time || kernel_.level != Level::Time) {
        const std::string source = Naming::source_of_leaf(kind, std::to_string(naming_.offset_of(kind) + index));
        line(fmt::format("const double {} = {};", codes_[id].text, source));
      }
    }
  }

  void line(std::string_view text) { body_.text += fmt::format("{}{}\n", indentation_, text); }

  void comment(const std::string& lines) {
    if (lines.empty()) {
      return;
    }
    body_.text += body_.text.empty() ? "" : "\n";
    std::size_t begin = 0;
    while (begin < lines.size()) {
      const std::size_t end = std::min(lines.find('\n', begin), lines.size());
      line("// " + lines.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  void write_section(const Section& section, const RolledSection& rolled) {
    section_ = &section;
    current_ = &rolled;
    declare_arrays();
    for (const Run& run : rolled.runs) {
      run_ = &run;
      if (run.iterations == 1) {
        write_iteration();
      } else {
        write_loop();
      }
    }
  }

  void declare_arrays() {
    arrays_.assign(current_->array_sizes.size(), "");
    std::map<std::size_t, NodeId> first_of_array;
    for (const auto& [id, element] : current_->elements) {
      if (element.index == 0) {
        first_of_array[element.array] = id;
      }
    }
    for (const auto& [array, id] : first_of_array) {
      const auto named = program_.names.find(id);
      arrays_[array] = named == program_.names.end()
                           ? scope_.enumerate("a")
                           : scope_.declare(named->second.substr(0, named->second.find_first_of("[.")) + "_all");
      line(fmt::format("std::array<double, {}> {};", current_->array_sizes[array], arrays_[array]));
    }
  }

  void write_loop() {
    declare_carried();
    line(fmt::format("for (std::size_t {0} = 0; {0} < {1}; ++{0}) {{", i_, run_->iterations));
    indentation_ = "  ";
    write_iteration();
    for (const auto& [producer, carried] : carried_) {
      line(fmt::format("{} = {};", carried, codes_.at(producer).text));
    }
    indentation_ = "";
    line("}");
    for (std::size_t u = run_->first; u < run_->first + run_->period * run_->iterations; ++u) {
      for (const NodeId id : section_->units[u].order) {
        codes_.erase(id);  // its name ended with the loop
        const auto element = current_->elements.find(id);
        if (element != current_->elements.end()) {
          codes_[id] = {fmt::format("{}[{}]", arrays_[element->second.array], element->second.index), Binding::Primary};
        }
      }
    }
  }

  /// Calls `visit(id, operand)` for every operand of every value that the loop computes.
  template <class Visit>
  void for_each_operand(const Visit& visit) const {
    for (std::size_t r = 0; r < run_->period; ++r) {
      const Unit& unit = section_->units[run_->first + r];
      const Unit& next = section_->units[run_->first + run_->period + r];
      for (std::size_t k = 0; k < unit.order.size(); ++k) {
        const Node& node = graph_[unit.order[k]];
        for (std::size_t o = 0; o < node.used_operands().size(); ++o) {
          visit(unit.order[k], operand_of(node.operands[o], graph_[next.order[k]].operands[o]));
        }
      }
    }
  }

  /// A value that each iteration computes from the one before stays in a variable: a chain of pivots must not wait for
  /// memory. A value that is only read once more, an iteration later, is better read from its array: such loops can be
  /// vectorised.
  void declare_carried() {
    std::map<NodeId, NodeId> candidates;  // what the first iteration reads, by the value that it becomes
    std::set<NodeId> recurrent;           // values that depend on a candidate
    for_each_operand([&](NodeId id, const Operand& operand) {
      if (operand.kind == Operand::Kind::Carried) {
        candidates.emplace(operand.producer, operand.node);
      }
      if (operand.kind == Operand::Kind::Carried ||
          (operand.kind == Operand::Kind::Same && recurrent.contains(operand.node))) {
        recurrent.insert(id);
      }
    });
    carried_.clear();
    for (const auto& [producer, read_first] : candidates) {
      if (recurrent.contains(producer)) {
        const std::string name = scope_.enumerate("v");
        line(fmt::format("double {} = {};", name, code_of(read_first).text));
        carried_.emplace(producer, name);
      }
    }
  }

  Operand operand_of(NodeId id, NodeId next) const {
    return program::operand_of(id, next, *run_, *section_, *current_, graph_);
  }

  /// The units of one iteration: of a loop, or the one unit that is written out.
  void write_iteration() {
    find_pairs();
    for (std::size_t r = 0; r < run_->period; ++r) {
      const Unit& unit = section_->units[run_->first + r];
      const Unit& next = section_->units[run_->first + r + (run_->iterations > 1 ? run_->period : 0)];
      for (std::size_t k = 0; k < unit.order.size(); ++k) {
        compute(unit.order[k], next.order[k]);
      }
      for (std::size_t k = 0; k < unit.stores.size(); ++k) {
        write_store(unit.stores[k], next.stores[k]);
      }
      for (std::size_t k = 0; k < unit.guards.size(); ++k) {
        write_guard(unit.guards[k], next.guards[k]);
      }
    }
  }

  void write_store(const Store& store, const Store& next) {
    const std::string value = read(store.value, next.value).text;
    if (store.target == Target::Energy) {
      line(fmt::format("return {};", value));
      return;
    }
    line(fmt::format("{}[{}] = {};", array_of(store.target), index_text(store.index, next.index), value));
  }

  void write_guard(const Guard& guard, const Guard& next) {
    std::string floor = fmt::format("{}.floor({})", island_, index_text(guard.row, next.row));
    if (graph_[guard.scale].kind != Kind::Constant) {
      floor += " * " + read(guard.scale, next.scale).text;
    }
    const std::string pivot = read(guard.pivot, next.pivot).text;
    line(guard.diagonal == guard.pivot ? fmt::format("{} &= {} >= {};", safe_, pivot, floor)
                                       : fmt::format("{} &= {}.{}({}, {}, {});", safe_, island_, condition_, pivot,
                                                     read(guard.diagonal, next.diagonal).text, floor));
  }

  std::string index_text(std::size_t first, std::size_t next) const {
    return affine(static_cast<long>(first), static_cast<long>(next) - static_cast<long>(first), i_);
  }

  void write_island(const IslandSolve& island, const RolledSection& rolled) {
    if (island.always_climbs) {
      write_unsafe(island);
      return;
    }
    // One flag and one branch: the pivot tests then cost next to nothing.
    const bool guarded = island.solve.has_guards();
    island_ = fmt::format("island_{}_", island.island + 1);
    condition_ = island.unknowns == program::Unknowns::Tangents ? "nearly_holds" : "holds";
    safe_ = guarded ? scope_.declare("safe") : "";
    if (guarded) {
      line(fmt::format("bool {} = true;", safe_));
    }
    write_section(island.solve, rolled);
    if (guarded) {
      line(fmt::format("if (!{}) [[unlikely]] {{", safe_));
      indentation_ = "  ";
      write_unsafe(island);
      indentation_ = "";
      line("}");
    }
  }

  void write_unsafe(const IslandSolve& island) {
    if (island.refuses) {
      line("return false;");
    } else {
      write_climb(island);
    }
  }

  /// The unknowns by the rest of the rank ladder. State and result are passed by value: nothing takes the address of
  /// `y` or `rate`, which can then live in registers.
  void write_climb(const IslandSolve& island) {
    body_.reads_state = true;
    const std::string u = scope_.declare("u");
    line(fmt::format("const auto {} = {}_{}(y);", u, climb_of(island.unknowns), island.island + 1));
    const std::vector<std::size_t>& speeds = program_.islands[island.island].speeds;
    const bool is_rate = island.unknowns == program::Unknowns::Accelerations;
    const std::string_view result = array_of(is_rate ? Target::Rate : Target::Shift);
    const std::size_t offset = is_rate ? naming_.coordinates.size() : 0;
    const std::size_t first = offset + speeds.front();
    if (speeds.size() >= program::shortest_run && speeds.back() - speeds.front() + 1 == speeds.size()) {
      line(fmt::format("for (std::size_t {0} = 0; {0} < {1}; ++{0}) {{", i_, speeds.size()));
      line(fmt::format("  {}[{}] = {}[{}];", result, affine(static_cast<long>(first), 1, i_), u, i_));
      line("}");
      return;
    }
    for (std::size_t j = 0; j < speeds.size(); ++j) {
      line(fmt::format("{}[{}] = {}[{}];", result, offset + speeds[j], u, j));
    }
  }

  /// Gives a value its code: a line of its own if it is used more than once, has a name in the model, or is long.
  void compute(NodeId id, NodeId next) {
    if (codes_.contains(id)) {
      return;  // the second of a pair
    }
    const Node& node = graph_[id];
    if (!write_pair(id, next)) {
      std::vector<Code> operands;
      for (std::size_t k = 0; k < node.used_operands().size(); ++k) {
        operands.push_back(read(node.operands[k], graph_[next].operands[k]));
      }
      const Code code = compose(node.op, operands);
      if (uses_[id] > 1 || program_.names.contains(id) || code.text.size() > longest_inline_text ||
          current_->elements.contains(id)) {
        const std::string name = declare(id);
        line(fmt::format("const double {} = {};", name, code.text));
        codes_[id] = {name, Binding::Primary};
      } else {
        codes_[id] = code;
      }
    }
    write_element(id, next);
  }

  /// Keeps a value that other iterations read.
  void write_element(NodeId id, NodeId next) {
    const auto element = current_->elements.find(id);
    if (element != current_->elements.end()) {
      const long stride = current_->elements.at(next).index - element->second.index;
      line(fmt::format("{}[{}] = {};", arrays_[element->second.array], affine(element->second.index, stride, i_),
                       codes_.at(id).text));
    }
  }

  /// sin and cos of one argument that one iteration needs are computed together.
  void find_pairs() {
    sines_.clear();
    cosines_.clear();
    for (std::size_t u = run_->first; u < run_->first + run_->period; ++u) {
      for (const NodeId id : section_->units[u].order) {
        const Node& node = graph_[id];
        if (node.op == Operator::Sin) {
          sines_[node.operands[0]] = id;
        } else if (node.op == Operator::Cos) {
          cosines_[node.operands[0]] = id;
        }
      }
    }
  }

  bool write_pair(NodeId id, NodeId next) {
    const Node& node = graph_[id];
    const auto sine = sines_.find(node.operands[0]);
    const auto cosine = cosines_.find(node.operands[0]);
    if ((node.op != Operator::Sin && node.op != Operator::Cos) || sine == sines_.end() || cosine == cosines_.end()) {
      return false;
    }
    const std::string sine_name = declare(sine->second);
    const std::string cosine_name = declare(cosine->second);
    line(fmt::format("const auto [{}, {}] = mbrt::sincos({});", sine_name, cosine_name,
                     read(node.operands[0], graph_[next].operands[0]).text));
    codes_[sine->second] = {sine_name, Binding::Primary};
    codes_[cosine->second] = {cosine_name, Binding::Primary};
    return true;
  }

  std::string declare(NodeId id) {
    const auto named = program_.names.find(id);
    if (named != program_.names.end()) {
      return scope_.declare(run_->iterations > 1 ? named->second.substr(0, named->second.find_first_of("[."))
                                                 : named->second);
    }
    const Node& node = graph_[id];
    return scope_.enumerate(node.op == Operator::Sin ? "s" : node.op == Operator::Cos ? "c" : "e");
  }

  /// The code of a value that is read, in a loop where the second iteration reads `next` instead.
  Code read(NodeId id, NodeId next) const {
    if (run_->iterations == 1) {
      return code_of(id);
    }
    const Operand operand = operand_of(id, next);
    const std::string index = affine(operand.first, operand.stride, i_);
    switch (operand.kind) {
      case Operand::Kind::Carried:
        if (carried_.contains(operand.producer)) {
          return {carried_.at(operand.producer), Binding::Primary};
        }
        [[fallthrough]];
      case Operand::Kind::Element:
        return {fmt::format("{}[{}]", arrays_[operand.array], index), Binding::Primary};
      case Operand::Kind::Leaf: {
        const Kind kind = graph_[id].kind;
        const long offset = static_cast<long>(naming_.offset_of(kind));
        return {Naming::source_of_leaf(kind, affine(operand.first + offset, operand.stride, i_)), Binding::Primary};
      }
      default:
        return code_of(id);
    }
  }

  Code code_of(NodeId id) const {
    const auto found = codes_.find(id);
    if (found != codes_.end()) {
      return found->second;
    }
    const Node& node = graph_[id];
    if (node.kind == Kind::Constant) {
      return literal(node.value);
    }
    if (node.kind > Kind::Acceleration && node.kind < Kind::Apply) {
      return {Naming::source_of_leaf(node.kind, std::to_string(node.index)), Binding::Primary};
    }
    const auto member = naming_.members.find(id);
    MBCC_ASSERT(member != naming_.members.end());
    return {member->second, Binding::Primary};
  }

  const Kernel& kernel_;
  const Program& program_;
  const graph::Graph& graph_;
  const Naming& naming_;
  std::vector<const Section*> sections_;  ///< of the kernel, then of its islands
  std::vector<RolledSection> rolled_;     ///< one per section
  std::map<NodeId, int> uses_;
  std::map<std::pair<Kind, std::uint32_t>, NodeId> unpacked_leaves_;

  Scope scope_;
  Body body_;
  std::string i_;  ///< the index of loops
  std::unordered_map<NodeId, Code> codes_;

  // Where the writer stands.
  std::string indentation_;
  const Section* section_ = nullptr;
  const RolledSection* current_ = nullptr;
  const Run* run_ = nullptr;
  std::vector<std::string> arrays_;           ///< names, by array of the section
  std::map<NodeId, NodeId> sines_, cosines_;  ///< of the iteration, by argument
  std::map<NodeId, std::string> carried_;     ///< variables that loops carry, by the value that they become
  std::string island_;
  std::string_view condition_;  ///< of its guards
  std::string safe_;
};

}  // namespace

Opening write_opening(const Kernel& kernel, const Program& program, const Naming& naming) {
  KernelWriter writer(kernel, program, naming);
  Body body = writer.write({});
  return {std::move(body), writer.within()};
}

Body write_kernel(const Kernel& kernel, const Program& program, const Naming& naming, const Comments& comments) {
  return KernelWriter(kernel, program, naming).write(comments);
}

}  // namespace mbcc::cpp
