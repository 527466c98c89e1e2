#include "program/series_plan.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "graph/in_order.hpp"
#include "mechanics/uncouple.hpp"
#include "program/expansion.hpp"

namespace mbcc::program {

namespace {

using graph::Expr;
using graph::Graph;
using graph::Kind;
using graph::Node;
using graph::product_of;
using mechanics::Derivatives;
using mechanics::Entry;
using mechanics::Equations;
using mechanics::Island;
using mechanics::Row;

class SeriesPlanner {
 public:
  SeriesPlanner(const model::System& system, const Equations& equations, const Derivatives& derivatives, Graph& graph)
      : system_(system), equations_(equations), derivatives_(derivatives), graph_(graph) {}

  SeriesPlan plan() {
    for (std::size_t j = 0; j < system_.speeds.size(); ++j) {
      accelerations_.push_back(free_acceleration(j));
    }
    for (const Island& island : derivatives_.islands) {
      solve(island);
    }
    accelerations_ = mechanics::coupled(derivatives_.couplings, std::move(accelerations_));
    advance_state();
    update_operands();
    plan_.products = lanes_.product_count(Pace::Fast);
    plan_.slow_products = lanes_.product_count(Pace::Slow);
    plan_.squares = lanes_.square_count(Pace::Fast);
    plan_.slow_squares = lanes_.square_count(Pace::Slow);
    return std::move(plan_);
  }

 private:
  Expr zero() { return graph_.constant(0); }
  Expr leaf(Kind kind, std::size_t index) { return graph_.leaf(kind, static_cast<std::uint32_t>(index)); }
  Expr speed_leaf(Kind kind, std::size_t speed) { return leaf(kind, system_.coordinates.size() + speed); }

  using ByIndex = std::function<Expr(std::uint32_t)>;

  static Expansion::Leaf leaves(const ByIndex& coordinates, Expr time, const ByIndex& speeds) {
    return [=](const Node& node) {
      return node.kind == Kind::Coordinate ? coordinates(node.index)
             : node.kind == Kind::Speed    ? speeds(node.index)
                                           : time;
    };
  }
  ByIndex of_state(Kind kind) {
    return [this, kind](std::uint32_t i) { return leaf(kind, i); };
  }
  ByIndex resting() {
    return [zero = zero()](std::uint32_t) { return zero; };
  }

  /// a_k along one speed.
  Expr free_acceleration(std::size_t speed) {
    const Expr free = derivatives_.free[speed];
    if (rests(free)) {
      return free * leaf(Kind::Impulse, 1);
    }
    plan_.start.push_back({Target::FreeNow, speed, free, speed});
    moving_forces_.push_back(speed);
    return leaf(Kind::FreeNow, speed);
  }

  static Pace pace_of(const model::Constraint& constraint) { return constraint.holonomic ? Pace::Fast : Pace::Slow; }

  /// An entry of A as number * rest.
  static std::pair<Expr, Expr> split(Expr entry) {
    const Expr factor = number(entry, entry.is_constant() ? 1 : numeric_factor(entry));
    return {factor, entry / factor};
  }

  /// Adds to accelerations what multipliers of lower order contribute: c_k.
  void add_known_reactions(const Island& island) {
    for (const std::size_t k : island.rows) {
      const Row& row = derivatives_.rows[k];
      for (const Entry& entry : row.solved) {
        const auto [factor, rest] = split(as_solved(row, entry.value));
        if (!rests(rest)) {
          const std::size_t lane = lanes_.reaction(pace_of(system_.constraints[k]), rest, k);
          Expr& acceleration = accelerations_[entry.speed];
          const Expr older = leaf(Kind::ProductSum, lane);
          const Expr known = older + product_of({leaf(Kind::LeftFirst, lane), leaf(Kind::RightNext, lane)});
          acceleration = acceleration + derivatives_.mobility[entry.speed] * factor * known;
        }
      }
    }
  }

  /// (k+1)(k+2) H of a holonomic row, (k+1) H of a nonholonomic one, divided by the row's content.
  Expr known_part(const Row& row) {
    const Expr value =
        system_.constraints[row.constraint].holonomic
            ? product_of({product_of({leaf(Kind::Order, 1), leaf(Kind::Order, 2)}), fast_ahead_.coefficient(row.value)})
            : product_of({leaf(Kind::Order, 1), slow_ahead_.coefficient(row.value)});
    return as_solved(row, value);
  }

  /// A_k c: entries that differ by a number, as the two ends of a rod do, are multiplied once.
  Expr along(const Row& row) {
    std::vector<std::pair<Expr, Expr>> terms;
    for (const Entry& entry : row.solved) {
      const auto [factor, rest] = split(as_solved(row, entry.value));
      const Expr multiple = factor * accelerations_[entry.speed];
      const auto same =
          std::find_if(terms.begin(), terms.end(), [like = rest](const auto& term) { return term.first == like; });
      if (same == terms.end()) {
        terms.emplace_back(rest, multiple);
      } else {
        same->second = same->second + multiple;
      }
    }
    Expr sum = zero();
    for (const auto& [rest, multiple] : terms) {
      sum = sum + rest * multiple;
    }
    return sum;
  }

  void solve(const Island& island) {
    const bool by_rows = rows_determine(island);
    if (!by_rows) {
      add_known_reactions(island);
    }
    mechanics::RightSides right;
    for (const std::size_t k : island.rows) {
      const Row& row = derivatives_.rows[k];
      right.b.push_back(-known_part(row));
      right.residual.push_back(right.b.back() - along(row));
    }
    const mechanics::Elimination elimination = eliminate(island, derivatives_, right, graph_);
    plan_.pivots.push_back(elimination.pivots);
    if (by_rows) {
      for (std::size_t j = 0; j < island.speeds.size(); ++j) {
        accelerations_[island.speeds[j]] = elimination.accelerations[j];
      }
      return;
    }
    for (std::size_t k = island.rows.size(); k-- > 0;) {  // as they become known: the last ones wait for nothing else
      multipliers_.emplace(island.rows[k], elimination.multipliers[k]);
      add_newest_reactions(derivatives_.rows[island.rows[k]], elimination.multipliers[k]);
    }
  }

  void add_newest_reactions(const Row& row, Expr multiplier) {
    for (const Entry& entry : row.solved) {
      const auto [factor, rest] = split(as_solved(row, entry.value));
      Expr& acceleration = accelerations_[entry.speed];
      acceleration = acceleration + derivatives_.mobility[entry.speed] * factor * (rest * multiplier);
    }
  }

  /// q_(k+2) of a coordinate with this rate. Where that is a speed, both divisions are one multiplication: the next
  /// pass waits for the result.
  Expr late_coordinate(Expr rate, Expansion& closing) {
    const Node node = rate.node();
    return node.kind == Kind::Speed
               ? product_of({leaf(Kind::InverseOrder, 1), leaf(Kind::InverseOrder, 2)}) * accelerations_[node.index]
               : product_of({leaf(Kind::InverseOrder, 2), closing.coefficient(rate)});
  }

  void advance_state() {
    const std::size_t coordinates = system_.coordinates.size();
    std::vector<Expr> speeds;
    for (std::size_t j = 0; j < system_.speeds.size(); ++j) {
      speeds.push_back(leaf(Kind::InverseOrder, 1) * accelerations_[j]);
      plan_.solve.push_back({Target::SpeedNext, coordinates + j, speeds.back(), j});
    }
    Expansion closing(
        graph_, lanes_, Pace::Slow, 1,
        leaves(of_state(Kind::StateNext), leaf(Kind::Impulse, 1), [&speeds](std::uint32_t j) { return speeds[j]; }));
    for (std::size_t i = 0; i < coordinates; ++i) {
      plan_.solve.push_back(
          {Target::CoordinateLate, i, late_coordinate(equations_.kinematics[i], closing), speeds.size() + i});
      plan_.start.push_back({Target::CoordinateFirst, i, equations_.kinematics[i], speeds.size() + i});
    }
  }

  /// What changes its sign where some expression of the motion changes its side.
  std::vector<Expr> switch_arguments() {
    std::vector<Expr> moving = equations_.kinematics;
    moving.insert(moving.end(), derivatives_.free.begin(), derivatives_.free.end());
    for (const Row& row : derivatives_.rows) {
      moving.push_back(row.value);
    }
    std::vector<Expr> arguments;
    for (const graph::NodeId id : graph::reachable(graph_, moving)) {
      const Node node = graph_[id];
      if (node.kind != Kind::Apply || graph::row(node.op).recurrence != graph::Recurrence::Switch ||
          node.op == graph::Operator::If) {
        continue;
      }
      const Expr left = graph_.at(node.operands[0]);
      const Expr argument = node.used_operands().size() == 1 ? left : left - graph_.at(node.operands[1]);
      if (!rests(argument) && std::find(arguments.begin(), arguments.end(), argument) == arguments.end()) {
        arguments.push_back(argument);
      }
    }
    return arguments;
  }

  /// The lanes' operands. New lanes may join while those of others are expanded.
  void update_operands() {
    Expansion fast(graph_, lanes_, Pace::Fast, 1, leaves(of_state(Kind::StateNext), leaf(Kind::Impulse, 1), resting()));
    Expansion slow(graph_, lanes_, Pace::Slow, 0,
                   leaves(of_state(Kind::StateNow), leaf(Kind::Impulse, 0),
                          [this](std::uint32_t j) { return speed_leaf(Kind::StateNow, j); }));
    const auto at = [&](Pace pace) -> Expansion& { return pace == Pace::Fast ? fast : slow; };
    const auto want = [&](Pace pace, Target target_fast, Target target_slow, std::size_t index, Expr value) {
      (pace == Pace::Fast ? plan_.fast : plan_.slow)
          .push_back({pace == Pace::Fast ? target_fast : target_slow, index, value, index});
    };
    for (const std::size_t speed : moving_forces_) {
      plan_.slow.push_back({Target::FreeNow, speed, slow.coefficient(derivatives_.free[speed]), speed});
    }
    for (const Expr argument : switch_arguments()) {
      const std::size_t index = plan_.switches++;
      plan_.start.push_back({Target::SwitchStart, index, argument, index});
      plan_.slow.push_back({Target::SwitchNow, index, slow.coefficient(argument), index});
    }
    for (std::size_t i = 0; i < lanes_.reactions().size(); ++i) {
      const ReactionLane lane = lanes_.reactions()[i];
      want(lane.pace, Target::LeftNext, Target::LeftNow, lane.index, at(lane.pace).coefficient(lane.entry));
      plan_.solve.push_back({Target::RightLate, lane.index, multipliers_.at(lane.constraint), lane.index});
    }
    for (std::size_t p = 0, s = 0; p < lanes_.products().size() || s < lanes_.squares().size();) {
      if (p < lanes_.products().size()) {
        const ProductLane lane = lanes_.products()[p++];
        const Expr left = at(lane.pace).coefficient(lane.left);
        want(lane.pace, Target::LeftNext, Target::SlowLeftNow, lane.index,
             lane.weighted ? at(lane.pace).order() * left : left);
        want(lane.pace, Target::RightNext, Target::SlowRightNow, lane.index, at(lane.pace).coefficient(lane.right));
      } else {
        const SquareLane lane = lanes_.squares()[s++];
        want(lane.pace, Target::SquareNext, Target::SlowSquareNow, lane.index, at(lane.pace).coefficient(lane.operand));
      }
    }
  }

  const model::System& system_;
  const Equations& equations_;
  const Derivatives& derivatives_;
  Graph& graph_;
  SeriesPlan plan_;
  Lanes lanes_;
  std::vector<Expr> accelerations_;  ///< u'_k, as far as it has been put together
  std::vector<std::size_t> moving_forces_;
  std::map<std::size_t, Expr> multipliers_;  ///< z_k by constraint

  // What constraints need of the coefficients that are sought: those with u'_k = 0.
  Expansion slow_ahead_{graph_, lanes_, Pace::Slow, 1,
                        leaves(of_state(Kind::StateNext), leaf(Kind::Impulse, 1), resting())};
  Expansion fast_ahead_{
      graph_, lanes_, Pace::Fast, 2,
      leaves(
          [this](std::uint32_t i) {
            return product_of({leaf(Kind::InverseOrder, 2), slow_ahead_.coefficient(equations_.kinematics[i])});
          },
          zero(), resting())};
};

}  // namespace

std::vector<Expr> SeriesPlan::roots() const {
  std::vector<Expr> roots;
  for (const auto* wanted : {&start, &fast, &slow, &solve}) {
    for (const Wanted& item : *wanted) {
      roots.push_back(item.value);
    }
  }
  for (const std::vector<mechanics::Pivot>& of_island : pivots) {
    for (const mechanics::Pivot& pivot : of_island) {
      roots.insert(roots.end(), {pivot.diagonal, pivot.pivot, pivot.scale});
    }
  }
  return roots;
}

SeriesPlan plan_series(const model::System& system, const Equations& equations, const Derivatives& derivatives,
                       graph::Graph& graph) {
  return SeriesPlanner(system, equations, derivatives, graph).plan();
}

}  // namespace mbcc::program
