#include "driver/structure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace mbcc {

namespace {

using graph::Operator;
using mechanics::Island;
using mechanics::Row;

std::string count(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

/// Names joined by spaces; the middle of a long list is left out.
std::string list(const std::vector<std::string>& names) {
  constexpr std::size_t longest = 12;
  if (names.size() <= longest) {
    return fmt::format("{}", fmt::join(names, " "));
  }
  return fmt::format("{} ... {} ({} in all)", fmt::join(names.begin(), names.begin() + longest - 1, " "), names.back(),
                     names.size());
}

class StructurePrinter {
 public:
  explicit StructurePrinter(const Compilation& compilation) : c_(compilation), system_(*compilation.system) {}

  std::string print() {
    totals();
    redundancy();
    for (std::size_t i = 0; i < c_.derivatives.islands.size(); ++i) {
      island(i);
    }
    unconstrained();
    operations();
    return std::move(text_);
  }

 private:
  std::size_t rank() const {
    return std::accumulate(c_.examination.ranks.begin(), c_.examination.ranks.end(), std::size_t{0});
  }

  void totals() {
    const auto holonomic =
        static_cast<std::size_t>(std::count_if(system_.constraints.begin(), system_.constraints.end(),
                                               [](const auto& constraint) { return constraint.holonomic; }));
    text_ += fmt::format("{}: {}, {}, {} of freedom\n", system_.name, count(system_.coordinates.size(), "coordinate"),
                         count(system_.speeds.size(), "speed"), count(system_.speeds.size() - rank(), "degree"));
    text_ += fmt::format("{}: {} holonomic, {} nonholonomic; rank {} at the start\n",
                         count(system_.constraints.size(), "constraint"), holonomic,
                         system_.constraints.size() - holonomic, rank());
  }

  void redundancy() {
    for (const std::size_t k : c_.examination.redundant) {
      text_ += fmt::format("  redundant: {}\n", constraint(k));
    }
  }

  void island(std::size_t i) {
    const Island& island = c_.derivatives.islands[i];
    text_ += fmt::format("island {}: {}, {}, rank {}\n", i + 1, count(island.speeds.size(), "speed"),
                         count(island.rows.size(), "constraint"), c_.examination.ranks[i]);
    std::vector<std::size_t> rows = island.rows;
    std::sort(rows.begin(), rows.end());
    for (const std::size_t k : rows) {
      const Row& row = c_.derivatives.rows[k];
      std::vector<std::string> names;
      for (const mechanics::Entry& entry : row.entries) {
        names.push_back(system_.speeds[entry.speed].name);
      }
      text_ += fmt::format("  {} ({}) joins {}\n", constraint(k),
                           system_.constraints[k].holonomic ? "holonomic" : "nonholonomic", list(names));
    }
  }

  void unconstrained() {
    std::vector<bool> joined(system_.speeds.size());
    for (const Island& island : c_.derivatives.islands) {
      for (const std::size_t speed : island.speeds) {
        joined[speed] = true;
      }
    }
    std::vector<std::string> names;
    for (std::size_t j = 0; j < joined.size(); ++j) {
      if (!joined[j]) {
        names.push_back(system_.speeds[j].name);
      }
    }
    if (!names.empty()) {
      text_ += fmt::format("without constraints: {}\n", list(names));
    }
  }

  void operations() {
    text_ += "operations\n";
    line("per state", c_.program->rates);
    line("per time", c_.program->time);
    line("per run", c_.program->prepare);
  }

  void line(std::string_view when, const program::Kernel& kernel) {
    for (const program::Section& section : kernel.sections) {
      add(section);
    }
    for (const program::IslandSolve& island : kernel.islands) {
      add(island.solve);
    }
    text_ += fmt::format("  {}: {}, {}, {}, {}\n", when, count(sums_, "addition"), count(products_, "multiplication"),
                         count(quotients_, "division"), count(functions_, "function"));
    sums_ = products_ = quotients_ = functions_ = 0;
  }

  void add(const program::Section& section) {
    for (const program::Unit& unit : section.units) {
      add(unit);
    }
  }

  void add(const program::Unit& unit) {
    for (const program::NodeId id : unit.order) {
      switch ((*c_.program->graph)[id].op) {
        case Operator::Add:
        case Operator::Subtract:
          ++sums_;
          break;
        case Operator::Multiply:
          ++products_;
          break;
        case Operator::Divide:
          ++quotients_;
          break;
        case Operator::Negate:
          break;  // part of the operation that uses it
        default:
          ++functions_;
      }
    }
  }

  std::string constraint(std::size_t k) const {
    return fmt::format("{} [{}]", system_.constraints[k].name, c_.sources.place(system_.constraints[k].span));
  }

  const Compilation& c_;
  const model::System& system_;
  std::string text_;
  std::size_t sums_ = 0, products_ = 0, quotients_ = 0, functions_ = 0;
};

}  // namespace

std::string print_structure(const Compilation& compilation) { return StructurePrinter(compilation).print(); }

}  // namespace mbcc
