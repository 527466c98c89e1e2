#include "mechanics/point.hpp"

#include "graph/evaluate.hpp"

namespace mbcc::mechanics {

Point initial_point(const model::System& system, const Equations& equations) {
  Point point;
  point.time = system.integration.from.value_or(0);
  for (const model::Parameter& parameter : system.parameters) {
    point.parameters.push_back(parameter.value);
  }
  point.coordinates = values_at(point, equations.initial_coordinates);
  point.speeds = values_at(point, equations.initial_speeds);
  return point;
}

std::vector<double> values_at(const Point& point, const std::vector<Expr>& expressions) {
  if (expressions.empty()) {
    return {};
  }
  const auto leaf = [&](const graph::Node& node) {
    switch (node.kind) {
      case graph::Kind::Constant:
        return node.value;
      case graph::Kind::Time:
        return point.time;
      case graph::Kind::Parameter:
        return point.parameters[node.index];
      case graph::Kind::Coordinate:
        return point.coordinates[node.index];
      case graph::Kind::Speed:
        return point.speeds[node.index];
      default:
        return 0.0;
    }
  };
  return graph::evaluate<double>(expressions.front().graph(), expressions, leaf);
}

double value_at(const Point& point, Expr expression) { return values_at(point, {expression}).front(); }

}  // namespace mbcc::mechanics
