// The order in which starts can be computed: the start of one thing may be said by that of another.

#include <fmt/format.h>

#include <algorithm>

#include "model/system_builder.hpp"

namespace mbcc::model {
namespace {

/// What the start of a variable needs: coordinates by their index, speeds behind them by theirs. The rate of an
/// expression needs the speeds of its coordinates, too.
std::set<std::size_t> needed_by(const Arena& arena, const System& system, ExpressionId start) {
  std::set<std::size_t> needed;
  std::set<ExpressionId> seen;
  std::vector<ExpressionId> open = {start};
  while (!open.empty()) {
    const ExpressionId id = open.back();
    open.pop_back();
    if (!seen.insert(id).second) {
      continue;
    }
    const Expression& expression = arena.expressions()[index(id)];
    if (expression.kind == ExpressionKind::Coordinate) {
      needed.insert(expression.index);
    } else if (expression.kind == ExpressionKind::Speed) {
      needed.insert(system.coordinates.size() + expression.index);
    } else if (expression.kind == ExpressionKind::Rate) {
      for (const CoordinateId coordinate : arena.coordinates_of(arena.scalar(expression.operands[0]))) {
        open.push_back(system[coordinate].rate);
      }
    }
    for (std::size_t k = 0; k < operand_count(expression); ++k) {
      open.push_back(expression.operands[k]);
    }
  }
  return needed;
}

/// The starts of a System, each with those that it needs; coordinates first, speeds behind them.
class Starts {
 public:
  Starts(const Arena& arena, const System& system) : system_(system), coordinates_(system.coordinates.size()) {
    for (const Coordinate& coordinate : system.coordinates) {
      needed_.push_back(needed_by(arena, system, coordinate.initial));
    }
    for (const Speed& speed : system.speeds) {
      needed_.push_back(needed_by(arena, system, speed.initial));
    }
  }

  /// Shorter than all of them if some wait for each other.
  std::vector<std::size_t> order() const {
    std::vector<std::vector<std::size_t>> needed_for(needed_.size());
    std::vector<std::size_t> missing;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < needed_.size(); ++i) {
      missing.push_back(needed_[i].size());
      for (const std::size_t needed : needed_[i]) {
        needed_for[needed].push_back(i);
      }
      if (needed_[i].empty()) {
        order.push_back(i);
      }
    }
    for (std::size_t k = 0; k < order.size(); ++k) {
      for (const std::size_t waiting : needed_for[order[k]]) {
        if (--missing[waiting] == 0) {
          order.push_back(waiting);
        }
      }
    }
    return order;
  }

  /// Starts each of which needs the next one, and the last one the first; `ordered` are those that are in no circle.
  std::vector<std::size_t> circle(const std::vector<std::size_t>& ordered) const {
    std::vector<bool> waits(needed_.size(), true);
    for (const std::size_t i : ordered) {
      waits[i] = false;
    }
    std::vector<std::size_t> path = {
        static_cast<std::size_t>(std::find(waits.begin(), waits.end(), true) - waits.begin())};
    while (true) {
      const std::set<std::size_t>& needed = needed_[path.back()];
      const std::size_t next = *std::find_if(needed.begin(), needed.end(), [&](std::size_t i) { return waits[i]; });
      if (const auto met = std::find(path.begin(), path.end(), next); met != path.end()) {
        return {met, path.end()};
      }
      path.push_back(next);
    }
  }

  const std::string& name(std::size_t i) const {
    return i < coordinates_ ? system_.coordinates[i].name : system_.speeds[i - coordinates_].name;
  }
  Span span(std::size_t i) const {
    return i < coordinates_ ? system_.coordinates[i].span : system_.speeds[i - coordinates_].span;
  }

 private:
  const System& system_;
  std::size_t coordinates_;
  std::vector<std::set<std::size_t>> needed_;
};

}  // namespace

void SystemBuilder::order_starts() {
  if (context_.report.found_errors()) {
    return;  // a start may be missing
  }
  const Starts starts(context_.arena, system_);
  system_.start_order = starts.order();
  if (system_.start_order.size() == system_.coordinates.size() + system_.speeds.size()) {
    return;
  }
  const std::vector<std::size_t> circle = starts.circle(system_.start_order);
  std::string path = fmt::format("`{}`", starts.name(circle.front()));
  for (std::size_t k = 1; k <= circle.size(); ++k) {
    path += fmt::format(" needs `{}`", starts.name(circle[k % circle.size()]));
  }
  context_.report.report(Finding::StartsInCircle, starts.span(circle.front()), starts.name(circle.front()), path);
}

}  // namespace mbcc::model
