#include "program/schedule.hpp"

#include <algorithm>
#include <set>

#include "model/methods.hpp"
#include "program/lower.hpp"
#include "program/plan.hpp"
#include "program/series_plan.hpp"

namespace mbcc {

namespace program {

namespace {

using graph::Kind;

/// Puts what is wanted into kernels, and collects on the way what earlier kernels have to provide.
class Scheduler {
 public:
  /// `roots` is all that kernels are asked for.
  Scheduler(const std::vector<graph::Expr>& roots, const std::vector<std::pair<graph::Expr, std::string>>& names,
            Program& program)
      : lowering_(roots, *program.graph), program_(program) {
    for (const auto& [value, name] : names) {
      if (lowering_.contains(value)) {
        program.names.try_emplace(lowering_(value), name);
      }
    }
  }

  Kernel kernel(Level level, const std::vector<Wanted>& wanted) {
    Kernel kernel;
    kernel.level = level;
    std::set<NodeId> computed;
    kernel.sections.push_back(section(level, wanted, computed));
    return kernel;
  }

  /// The kernel of a plan of the motion, or of its tangent.
  template <class PlanOfMotion>
  Kernel motion(const PlanOfMotion& plan) {
    Kernel kernel;
    std::set<NodeId> computed;
    kernel.sections.push_back(section(Level::State, plan.kinematics, computed));
    kernel.sections.push_back(section(Level::State, plan.free_accelerations, computed));
    for (const IslandPlan& island : plan.islands) {
      kernel.islands.push_back(solve(island, computed));
    }
    return kernel;
  }

  Kernel shifts(const std::vector<IslandPlan>& islands) {
    Kernel kernel;
    std::set<NodeId> computed;
    for (const IslandPlan& island : islands) {
      kernel.islands.push_back(solve(island, computed));
    }
    return kernel;
  }

  SeriesKernels series(const SeriesPlan& plan) {
    SeriesKernels series;
    series.fast = kernel(Level::Order, plan.fast);
    series.slow = kernel(Level::Order, plan.slow);
    series.solve = kernel(Level::Order, plan.solve);
    std::set<NodeId> computed;
    series.start.sections.push_back(section(Level::State, plan.start, computed));
    provide(Level::State, computed, series.start);
    for (std::size_t i = 0; i < plan.pivots.size(); ++i) {
      IslandSolve& island = series.start.islands.emplace_back();
      island.island = i;
      island.refuses = true;
      island.always_climbs = must_climb(plan.pivots[i], program_.islands[i].speeds.size());
      for (std::size_t k = 0; k < plan.pivots[i].size(); ++k) {
        add_guard(k, plan.pivots[i][k], computed, island.solve.units.emplace_back());
      }
    }
    series.products = plan.products;
    series.slow_products = plan.slow_products;
    series.squares = plan.squares;
    series.slow_squares = plan.slow_squares;
    series.switches = plan.switches;
    return series;
  }

  /// The kernel of a level below State: what kernels after it asked for.
  Kernel provider(Level level) {
    Kernel kernel;
    kernel.level = level;
    std::set<NodeId> computed;
    provide(level, computed, kernel);
    return kernel;
  }

  /// Takes over what the kernels of another scheduler of the same program asked for.
  void join(const Scheduler& other) {
    for (std::size_t level = 0; level < needed_.size(); ++level) {
      needed_[level].insert(other.needed_[level].begin(), other.needed_[level].end());
    }
  }

 private:
  void provide(Level level, std::set<NodeId>& computed, Kernel& kernel) {
    Section section;
    for (const NodeId id : needed_[static_cast<std::size_t>(level)]) {
      Unit unit;
      visit(id, level, computed, unit.order);
      section.units.push_back(std::move(unit));
      kernel.provides.push_back(id);
    }
    kernel.sections.push_back(std::move(section));
  }

  /// One unit for each run of `wanted` of the same group.
  Section section(Level level, const std::vector<Wanted>& wanted, std::set<NodeId>& computed) {
    Section section;
    add(wanted, level, computed, section);
    return section;
  }

  void add(const std::vector<Wanted>& wanted, Level level, std::set<NodeId>& computed, Section& section) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (i == 0 || wanted[i].group != wanted[i - 1].group) {
        section.units.emplace_back();
      }
      Unit& unit = section.units.back();
      const NodeId value = lowering_(wanted[i].value);
      visit(value, level, computed, unit.order);
      unit.stores.push_back({wanted[i].target, wanted[i].index, value});
    }
  }

  /// Appends `id` and what it needs to `order`, operands first, except what is computed or known already.
  void visit(NodeId id, Level level, std::set<NodeId>& computed, std::vector<NodeId>& order) {
    const graph::Node& node = (*program_.graph)[id];
    program_.keeps_time |= node.kind == Kind::Time && level >= Level::State;
    if (node.kind != Kind::Apply || computed.contains(id)) {
      return;
    }
    if (node.level < level && level > Level::Parameter) {
      needed_[static_cast<std::size_t>(std::max(node.level, Level::Parameter))].insert(id);
      return;
    }
    computed.insert(id);
    for (const NodeId operand : node.used_operands()) {
      visit(operand, level, computed, order);
    }
    order.push_back(id);
  }

  /// visit() for what is live of a value that may not be: a sum may be used, and the multiple that has its name not.
  void visit_live(NodeId id, const std::set<NodeId>& live, std::set<NodeId>& computed, std::vector<NodeId>& order) {
    if (live.contains(id)) {
      visit(id, Level::State, computed, order);
    } else if ((*program_.graph)[id].level == Level::State) {
      for (const NodeId operand : (*program_.graph)[id].used_operands()) {
        visit_live(operand, live, computed, order);
      }
    }
  }

  /// What the stores and guards of an island need, at level State.
  std::set<NodeId> live_values(const IslandPlan& plan) {
    std::set<NodeId> live;
    std::vector<NodeId> order;
    for (const mechanics::Pivot& pivot : plan.elimination.pivots) {
      visit(lowering_(pivot.pivot), Level::State, live, order);
      visit(lowering_(pivot.diagonal), Level::State, live, order);
      visit(lowering_(pivot.scale), Level::State, live, order);
    }
    for (const Wanted& unknown : plan.solution) {
      visit(lowering_(unknown.value), Level::State, live, order);
    }
    return live;
  }

  static bool is_known(const mechanics::Pivot& pivot) {
    return pivot.pivot.is_constant() && pivot.diagonal.is_constant();
  }

  /// Whether the plain solve can never stand: more rows than speeds make S singular, and constant pivots may be unsafe.
  static bool must_climb(const std::vector<mechanics::Pivot>& pivots, std::size_t speeds) {
    return pivots.size() > speeds || std::any_of(pivots.begin(), pivots.end(), [&](const mechanics::Pivot& pivot) {
             const double value = pivot.pivot.node().value;
             return is_known(pivot) &&
                    !(value > 0 && value >= plain_pivot_ratio(pivots.size()) * pivot.diagonal.node().value);
           });
  }

  void add_guard(std::size_t row, const mechanics::Pivot& pivot, std::set<NodeId>& computed, Unit& unit) {
    if (!is_known(pivot)) {
      for (const graph::Expr value : {pivot.pivot, pivot.diagonal, pivot.scale}) {
        visit(lowering_(value), Level::State, computed, unit.order);
      }
      unit.guards.push_back({row, lowering_(pivot.diagonal), lowering_(pivot.pivot), lowering_(pivot.scale)});
    }
  }

  /// Rows in the order of the model, pivots in the order of elimination, multipliers backwards, unknowns.
  IslandSolve solve(const IslandPlan& plan, std::set<NodeId>& computed) {
    IslandSolve solve;
    solve.island = plan.island;
    solve.unknowns = plan.unknowns;
    solve.refuses = plan.unknowns == Unknowns::Tangents;
    const mechanics::Elimination& elimination = plan.elimination;
    if (must_climb(plan.elimination.pivots, plan.solution.size())) {
      solve.always_climbs = true;
      return solve;
    }
    const std::set<NodeId> live = live_values(plan);
    const auto add_unit = [&](const std::vector<graph::Expr>& values) -> Unit& {
      Unit& unit = solve.solve.units.emplace_back();
      for (const graph::Expr value : values) {
        visit_live(lowering_(value), live, computed, unit.order);
      }
      return unit;
    };
    for (const auto* rows : {&elimination.rows, &elimination.couplings}) {
      for (const std::vector<graph::Expr>& row : *rows) {
        add_unit(row);
      }
    }
    for (std::size_t k = 0; k < elimination.pivots.size(); ++k) {
      const mechanics::Pivot& pivot = elimination.pivots[k];
      add_guard(plan.floors[k], pivot, computed, add_unit({pivot.pivot, elimination.forward[k]}));
    }
    for (const graph::Expr quotient : elimination.quotients) {
      add_unit({quotient});
    }
    for (auto z = elimination.multipliers.rbegin(); z != elimination.multipliers.rend(); ++z) {
      add_unit({*z});
    }
    for (const std::vector<graph::Expr>& terms : elimination.constraint_terms) {
      add_unit(terms);
    }
    add(plan.solution, Level::State, computed, solve.solve);
    std::erase_if(solve.solve.units,
                  [](const Unit& unit) { return unit.order.empty() && unit.stores.empty() && unit.guards.empty(); });
    return solve;
  }

  Lowering lowering_;
  Program& program_;
  std::array<std::set<NodeId>, 5> needed_;  ///< by level, of values that later kernels read
};

}  // namespace

}  // namespace program

program::Program schedule(const model::System& system, const mechanics::Equations& equations,
                          const mechanics::Derivatives& derivatives, graph::Graph& graph, bool with_series) {
  using namespace program;
  const Plan plan = make_plan(system, equations, derivatives, graph);
  Program program;
  for (const mechanics::Island& island : derivatives.islands) {
    program.islands.push_back({island.rows, island.speeds});
  }
  Scheduler scheduler(plan.roots(), plan.names, program);
  program.initial = scheduler.kernel(Level::Parameter, plan.initial);
  program.rates = scheduler.motion(plan);
  program.position_shifts = scheduler.shifts(plan.position_shifts);
  program.velocity_shifts = scheduler.shifts(plan.velocity_shifts);
  for (const std::vector<Wanted>& rows : plan.island_rows) {
    program.island_rows.push_back(scheduler.kernel(Level::State, rows));
  }
  program.couple = scheduler.kernel(Level::State, plan.couple);
  program.uncouple = scheduler.kernel(Level::State, plan.uncouple);
  program.move = scheduler.kernel(Level::State, plan.move);
  program.constraint_errors = scheduler.kernel(Level::State, plan.constraint_errors);
  program.energy = scheduler.kernel(Level::State, plan.energy);
  program.outputs = scheduler.kernel(Level::State, plan.outputs);
  program.applied_forces = scheduler.kernel(Level::State, plan.applied_forces);
  if (with_series) {
    const SeriesPlan series = plan_series(system, equations, derivatives, graph);
    Scheduler series_scheduler(series.roots(), plan.names, program);  // lowers apart: other kernels stay as they are
    program.series = series_scheduler.series(series);
    scheduler.join(series_scheduler);
  }
  if (needs(system.integration, model::Code::Tangent)) {
    const TangentPlan tangent = plan_tangent(plan, system, equations, derivatives, graph);
    Scheduler tangent_scheduler(tangent.roots(), plan.names, program);  // likewise
    program.tangent = tangent_scheduler.motion(tangent);
    scheduler.join(tangent_scheduler);
  }
  program.time = scheduler.provider(Level::Time);
  program.prepare = scheduler.provider(Level::Parameter);
  return program;
}

}  // namespace mbcc
