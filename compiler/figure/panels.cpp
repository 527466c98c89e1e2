#include "figure/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

namespace mbcc::figure {

namespace {

/// What is recorded of a particle or a constraint, in the order of the panels.
enum Level : std::size_t { Position, Velocity, Acceleration };
constexpr std::size_t levels = 3;

struct Place {
  std::string figure;  ///< title of the figure that the column belongs to
  Level level;
};

/// `x`, `vy`, `az`.
std::optional<Level> component_level(std::string_view component) {
  constexpr std::string_view axes = "xyz";
  if (component.empty() || axes.find(component.back()) == axes.npos) {
    return std::nullopt;
  }
  const std::string_view derivative = component.substr(0, component.size() - 1);
  return derivative.empty()  ? std::optional(Position)
         : derivative == "v" ? std::optional(Velocity)
         : derivative == "a" ? std::optional(Acceleration)
                             : std::nullopt;
}

/// A component of a numbered or of a named particle: `vx1`, `bob.vx`, `p[1,2].x`.
std::optional<Place> particle_column(std::string_view column) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t dot = column.rfind('.');
  const bool named = dot != column.npos;
  const std::size_t end = named ? dot : std::min(column.find_first_of(digits), column.size());
  const std::string_view number = named ? "" : column.substr(end);
  const auto level = component_level(named ? column.substr(dot + 1) : column.substr(0, end));
  if (!level || (named ? end == 0 : number.empty() || number.find_first_not_of(digits) != number.npos)) {
    return std::nullopt;
  }
  return Place{named ? std::string(column.substr(0, end)) : fmt::format("particle {}", number), *level};
}

/// An error of a constraint: `rod.velocity_error`; the place is the constraint's name.
std::optional<Place> error_column(std::string_view column) {
  constexpr std::array<std::string_view, levels> endings = {".position_error", ".velocity_error",
                                                            ".acceleration_error"};
  for (const Level level : {Position, Velocity, Acceleration}) {
    if (column.ends_with(endings[level])) {
      return Place{std::string(column.substr(0, column.size() - endings[level].size())), level};
    }
  }
  return std::nullopt;
}

constexpr std::string_view energy_column = "energy";

/// The figure called `title`, with panels that have no curves yet if it is new.
Figure& figure_called(std::vector<Figure>& figures, const std::string& title, Measure measure,
                      const std::array<const char*, levels>& labels) {
  for (Figure& figure : figures) {
    if (figure.title == title) {
      return figure;
    }
  }
  Figure& figure = figures.emplace_back(Figure{title, {}, {}, {}});
  for (const char* const label : labels) {
    figure.panels.push_back({label, measure, {}});
  }
  return figure;
}

/// Of more constraints than a legend can tell apart, the largest error is shown.
void summarize_errors(Panel& panel) {
  constexpr std::size_t most_curves = 7;
  if (panel.curves.size() <= most_curves) {
    return;
  }
  Curve largest{fmt::format("largest of {}", panel.curves.size()), {}};
  for (const Curve& curve : panel.curves) {
    largest.columns.push_back(curve.columns.front());
  }
  panel.curves = {std::move(largest)};
}

/// What has a panel of its own, three to a figure.
void append_singles(std::vector<Figure>& figures, const std::vector<Panel>& singles) {
  const auto is_energy = [](const Panel& panel) { return panel.measure == Measure::Change; };
  for (std::size_t first = 0; first < singles.size(); first += levels) {
    const std::size_t last = std::min(first + levels, singles.size());
    const bool has_energy = is_energy(singles[first]);
    const std::string title = !has_energy ? "outputs" : last == first + 1 ? "energy" : "energy and outputs";
    figures.push_back(
        {title, {singles.begin() + static_cast<long>(first), singles.begin() + static_cast<long>(last)}, {}, {}});
  }
}

}  // namespace

std::vector<Figure> figures_of(std::span<const std::string> columns) {
  std::vector<Figure> figures, errors;
  std::vector<Panel> singles;
  for (const std::string& column : columns.subspan(std::min<std::size_t>(1, columns.size()))) {
    if (const auto error = error_column(column)) {
      Figure& figure = figure_called(errors, "constraint errors", Measure::Magnitude,
                                     {"of position", "of velocity", "of acceleration"});
      figure.panels[error->level].curves.push_back({error->figure, {column}});
    } else if (const auto component = particle_column(column)) {
      Figure& figure =
          figure_called(figures, component->figure, Measure::Value, {"coordinates", "velocities", "accelerations"});
      figure.panels[component->level].curves.push_back({column, {column}});
      if (component->level != Acceleration) {
        (component->level == Position ? figure.position : figure.velocity).push_back(column);
      }
    } else if (column == energy_column) {
      singles.insert(singles.begin(), {"energy drift", Measure::Change, {{column, {column}}}});
    } else {
      singles.push_back({column, Measure::Value, {{column, {column}}}});
    }
  }
  for (Figure& figure : errors) {
    std::for_each(figure.panels.begin(), figure.panels.end(), summarize_errors);
    figures.push_back(std::move(figure));
  }
  append_singles(figures, singles);
  for (Figure& figure : figures) {
    std::erase_if(figure.panels, [](const Panel& panel) { return panel.curves.empty(); });
  }
  return figures;
}

std::vector<Figure> figures_of(std::span<const Table> tables) {
  std::vector<std::string> columns;
  std::set<std::string_view> seen;
  for (const Table& table : tables) {
    for (const std::string& name : table.names) {
      if (seen.insert(name).second) {
        columns.push_back(name);
      }
    }
  }
  return figures_of(columns);
}

std::vector<double> samples(const Table& table, Measure measure, const Curve& curve) {
  std::vector<double> values;
  for (const std::string& name : curve.columns) {
    const std::span<const double> column = table[name];
    if (column.empty()) {
      return {};
    }
    values.resize(column.size());
    for (std::size_t row = 0; row < column.size(); ++row) {
      switch (measure) {
        case Measure::Value:
          values[row] = column[row];
          break;
        case Measure::Magnitude:
          values[row] = std::max(values[row], std::abs(column[row]));
          break;
        case Measure::Change:
          values[row] = column[row] - column.front();
          break;
      }
    }
  }
  return values;
}

}  // namespace mbcc::figure
