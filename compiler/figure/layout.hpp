#pragma once
// Where the figures stand on the pages of a picture.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "figure/drawing.hpp"

namespace mbcc::figure {

/// The entries above a panel, set in rows of `columns`.
struct Legend {
  std::size_t columns = 1;
  std::size_t rows = 0;  ///< those that do not fit beside the panel's label
};

Legend legend_of(const DrawnPanel& panel);

/// A rectangle, in points from the top left corner of its page.
struct Box {
  double left, top, right, bottom;
};

struct Point {
  double left, top;
};

struct PlacedFigure {
  std::size_t index;  ///< among the figures
  Point title;
  std::vector<Box> panels;  ///< the areas inside the axes
};

struct Page {
  double width, height;
  std::vector<Point> results;  ///< where the names of the results stand, if there are several
  std::vector<PlacedFigure> figures;
};

/// From the sample of a line to the text that it belongs to.
inline constexpr double sample_length = 22;

/// All figures on one page, in a grid. `results` are the names of the results.
Page single_page(std::span<const DrawnFigure> figures, std::span<const std::string> results);

/// A page for each figure, all of the same size.
std::vector<Page> separate_pages(std::span<const DrawnFigure> figures, std::span<const std::string> results);

}  // namespace mbcc::figure
