#include <fmt/format.h>

#include "graph/feed.hpp"
#include "mechanics/point.hpp"
#include "mechanics/print.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Feed;
using graph::Kind;
using graph::Node;

/// A variable with respect to which partial derivatives are taken.
struct Variable {
  std::string name;
  double value;
};

bool occurs(Expr expression, Kind kind) {
  for (const graph::NodeId id : graph::reachable(expression.graph(), std::array{expression})) {
    if (expression.graph()[id].kind == kind) {
      return true;
    }
  }
  return false;
}

/// The variables that the paper carries: the coordinates, with t and the velocities where they occur.
class Variables {
 public:
  Variables(const model::System& system, const Point& point, bool with_time, bool with_speeds) {
    if (with_time) {
      all_.push_back({"t", point.time});
    }
    first_coordinate_ = all_.size();
    for (std::size_t i = 0; i < system.coordinates.size(); ++i) {
      all_.push_back({system.coordinates[i].name, point.coordinates[i]});
    }
    first_speed_ = all_.size();
    for (std::size_t j = 0; with_speeds && j < system.speeds.size(); ++j) {
      all_.push_back({system.speeds[j].name, point.speeds[j]});
    }
  }

  std::size_t size() const { return all_.size(); }
  const Variable& operator[](std::size_t i) const { return all_[i]; }
  std::size_t index_of(const Node& leaf) const {
    return leaf.kind == Kind::Time ? 0
                                   : leaf.index + (leaf.kind == Kind::Coordinate ? first_coordinate_ : first_speed_);
  }

 private:
  std::vector<Variable> all_;
  std::size_t first_coordinate_ = 0;
  std::size_t first_speed_ = 0;
};

Feed feed_of(Expr expression, const Variables& variables, const Point& point, Feed::Order order) {
  const auto leaf = [&](const Node& node) {
    if (node.kind == Kind::Constant || node.kind == Kind::Parameter) {
      const double value = node.kind == Kind::Constant ? node.value : point.parameters[node.index];
      return Feed::constant(value, variables.size(), order);
    }
    const std::size_t i = variables.index_of(node);
    return Feed::variable(variables[i].value, i, variables.size(), order);
  };
  return graph::evaluate<Feed>(expression.graph(), std::array{expression}, leaf).front();
}

std::string print_feed(const Feed& feed, const Variables& variables, bool second_order) {
  std::string lines = fmt::format("  value {}\n", feed.value());
  for (std::size_t i = 0; i < variables.size(); ++i) {
    lines += fmt::format("  d/d{} {}\n", variables[i].name, feed.first(i));
  }
  for (std::size_t i = 0; second_order && i < variables.size(); ++i) {
    for (std::size_t j = i; j < variables.size(); ++j) {
      lines += fmt::format("  d2/d{} d{} {}\n", variables[i].name, variables[j].name, feed.second(i, j));
    }
  }
  return lines;
}

}  // namespace

std::string print_partials(const model::System& system, const Equations& equations) {
  const Point start = initial_point(system, equations);
  std::string text;
  for (std::size_t k = 0; k < system.constraints.size(); ++k) {
    const model::Constraint& constraint = system.constraints[k];
    const bool with_time = occurs(equations.constraints[k], Kind::Time);
    const bool with_speeds = !constraint.holonomic;
    const Variables variables(system, start, with_time, with_speeds);
    const Feed::Order order = constraint.holonomic ? Feed::Order::Second : Feed::Order::First;
    text += fmt::format("{}: t-flag {}, v-flag {}\n", constraint.name, with_time, with_speeds);
    text += print_feed(feed_of(equations.constraints[k], variables, start, order), variables, constraint.holonomic);
  }
  return text;
}

}  // namespace mbcc::mechanics
