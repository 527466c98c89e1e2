#include <fmt/format.h>

#include "model/expression_text.hpp"
#include "model/resolve.hpp"

namespace mbcc {
namespace {

using namespace model;

void section(std::string& text, std::string_view title, const std::vector<std::string>& lines) {
  if (lines.empty()) {
    return;
  }
  text += fmt::format("\n{}\n", title);
  for (const std::string& line : lines) {
    text += fmt::format("  {}\n", line);
  }
}

template <class Item, class Line>
void section(std::string& text, std::string_view title, const std::vector<Item>& items, const Line& line) {
  std::vector<std::string> lines;
  for (const Item& item : items) {
    lines.push_back(line(item));
  }
  section(text, title, lines);
}

std::string print(const Constraint& constraint, const ExpressionText& write) {
  std::string loop;
  if (constraint.made_by && !constraint.made_by->indices.empty()) {
    loop = fmt::format(", in a loop at {}", fmt::join(constraint.made_by->indices, ","));
  }
  return fmt::format("{}: {} = 0   ({}{})", constraint.name, write(constraint.value),
                     constraint.holonomic ? "holonomic" : "nonholonomic", loop);
}

std::vector<std::string> print(const Integration& integration) {
  std::vector<std::string> lines;
  const auto add = [&](std::string_view name, const auto& value) {
    if (value) {
      lines.push_back(fmt::format("{} = {}", name, *value));
    }
  };
  add("from", integration.from);
  add("to", integration.to);
  add("step", integration.step);
  add("method", integration.method);
  add("tolerance", integration.tolerance);
  add("every", integration.every);
  return lines;
}

}  // namespace

std::string print(const System& system) {
  const ExpressionText write(system);
  std::string text = fmt::format("system {}\ndimension {}\n", system.name, system.dimension);
  section(text, "parameters", system.parameters,
          [](const Parameter& parameter) { return fmt::format("{} = {}", parameter.name, parameter.value); });
  section(text, "expressions used more than once", write.named());
  section(text, "coordinates", system.coordinates, [&](const Coordinate& coordinate) {
    const std::string moves = system.speed_of(coordinate) ? "" : fmt::format(", rate {}", write(coordinate.rate));
    return fmt::format("{}: starts at {}{}", coordinate.name, write(coordinate.initial), moves);
  });
  section(text, "speeds", system.speeds, [&](const Speed& speed) {
    return fmt::format("{}: starts at {}, inertia {}", speed.name, write(speed.initial), write(speed.inertia));
  });
  section(text, "forces", system.forces, [&](const Force& force) {
    return fmt::format("{}: {} along {}", force.name, write(force.value), write(force.along));
  });
  const auto energy = [&](const Energy& term) { return write(term.value); };
  section(text, "kinetic energy", system.kinetic, energy);
  section(text, "potential energy", system.potential, energy);
  section(text, "constraints", system.constraints,
          [&](const Constraint& constraint) { return print(constraint, write); });
  section(text, "outputs", system.outputs,
          [&](const Output& output) { return fmt::format("{} = {}", output.name, write(output.value)); });
  section(text, "integrate", print(system.integration));
  return text;
}

}  // namespace mbcc
