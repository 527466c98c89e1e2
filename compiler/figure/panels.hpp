#pragma once
// Which figures a result is shown in: a function of the names of its columns alone.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "figure/table.hpp"

namespace mbcc::figure {

/// What a panel shows of its columns.
enum class Measure {
  Value,      ///< the column
  Magnitude,  ///< its absolute value, on a logarithmic axis; the largest one where a curve has several columns
  Change,     ///< the column less its first value
};

struct Curve {
  std::string label;
  std::vector<std::string> columns;  ///< several only for Measure::Magnitude
};

struct Panel {
  std::string label;  ///< "coordinates", "energy drift", the name of an output
  Measure measure = Measure::Value;
  std::vector<Curve> curves;  ///< at least one
};

/// Panels that belong together, over one axis of time; at most three.
struct Figure {
  std::string title;  ///< "particle 1", "bob", "constraint errors"
  std::vector<Panel> panels;
  std::vector<std::string> position;  ///< of a particle: the columns of its coordinates
  std::vector<std::string> velocity;  ///< and of their rates
};

/// A figure of coordinates, velocities and accelerations for each particle; the constraint errors at these three
/// levels; the drift of the energy, and every output. All in the order of the columns.
std::vector<Figure> figures_of(std::span<const std::string> columns);

/// Those of several results together, each column once.
std::vector<Figure> figures_of(std::span<const Table> tables);

/// The points of a curve, one for each row; empty if the table lacks one of its columns.
std::vector<double> samples(const Table& table, Measure measure, const Curve& curve);

}  // namespace mbcc::figure
