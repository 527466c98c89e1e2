#pragma once
// Figures as they are drawn: the lines, axes and legends of their panels.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "figure/axis.hpp"
#include "figure/panels.hpp"

namespace mbcc::figure {

/// A curve of one result. Of many rows those are left that a picture shows.
struct Line {
  std::vector<double> time, values;
  std::size_t colour;  ///< from 0; errors of one constraint have one colour in all panels
  std::size_t result;  ///< which of the results: its dash pattern
  bool smooth;         ///< joined by a smooth curve, not by straight lines: Note [few rows]
  std::string title;   ///< in the legend; empty if it has no entry there
};

/// Note [few rows]: methods that choose their steps need few of them, and straight lines between these would draw
/// corners that the motion does not have. Up to 400 rows are therefore joined by monotone cubic splines: they go
/// through every row, and never beyond two neighbours, so that no peak and no swing is drawn that was not recorded.
/// Errors are joined by straight lines, for they have no reason to be smooth.

struct DrawnPanel {
  std::string label;
  Axis axis;
  std::vector<Line> lines;  ///< those of the first result first
};

struct DrawnFigure {
  std::string title;
  std::vector<DrawnPanel> panels;
};

/// A result that lacks a column lacks its line.
DrawnFigure draw(const Figure& figure, std::span<const Table> results);

}  // namespace mbcc::figure
