#include "figure/layout.hpp"

#include <algorithm>

namespace mbcc::figure {

namespace {

// In points. Letters are about half as wide as the ten points that they are high.
constexpr double panel_width = 360, panel_height = 130;
constexpr double left_margin = 66, right_margin = 24;
constexpr double title_height = 34, label_height = 22, legend_row_height = 14, axis_height = 44;
constexpr double letter_width = 6.3, sample_width = 36;
constexpr double figure_width = left_margin + panel_width + right_margin;

double header_height(const DrawnPanel& panel) {
  return label_height + static_cast<double>(legend_of(panel).rows) * legend_row_height;
}

double tallest(std::span<const DrawnFigure> figures) {
  double tallest = 0;
  for (const DrawnFigure& figure : figures) {
    double height = title_height + axis_height;
    for (const DrawnPanel& panel : figure.panels) {
      height += header_height(panel) + panel_height;
    }
    tallest = std::max(tallest, height);
  }
  return tallest;
}

PlacedFigure place(const DrawnFigure& figure, std::size_t index, double left, double top) {
  PlacedFigure placed{index, {left + left_margin, top + title_height / 2}, {}};
  double y = top + title_height;
  for (const DrawnPanel& panel : figure.panels) {
    y += header_height(panel);
    placed.panels.push_back({left + left_margin, y, left + left_margin + panel_width, y + panel_height});
    y += panel_height;
  }
  return placed;
}

/// A page that ends below the names of several results, in as many rows as they need.
Page empty_page(double width, std::span<const std::string> results) {
  Page page{width, 0, {}, {}};
  if (results.size() < 2) {
    return page;
  }
  Point end{left_margin, label_height / 2};
  for (const std::string& name : results) {
    const double length = 2 * sample_width + letter_width * static_cast<double>(name.size());
    if (end.left > left_margin && end.left + length > width) {
      end = {left_margin, end.top + legend_row_height};
    }
    page.results.push_back({end.left + sample_length, end.top});
    end.left += length;
  }
  page.height = end.top + label_height / 2;
  return page;
}

/// Few figures stand side by side, more of them in as many rows as columns, up to what a screen shows.
std::size_t grid_columns(std::size_t figures) {
  constexpr std::size_t most_columns = 4;
  std::size_t columns = std::min<std::size_t>(figures, 3);
  if (figures == 4) {
    columns = 2;
  } else if (figures > 9) {
    columns = most_columns;
  }
  return columns;
}

}  // namespace

Legend legend_of(const DrawnPanel& panel) {
  std::size_t entries = 0;
  std::size_t longest = 0;
  for (const Line& line : panel.lines) {
    entries += line.title.empty() ? 0U : 1U;
    longest = std::max(longest, line.title.size());
  }
  if (entries == 0) {
    return {};
  }
  const double width = static_cast<double>(longest) * letter_width + sample_width;
  const double beside_label = panel_width - static_cast<double>(panel.label.size()) * letter_width;
  const auto fitting = [width](double space) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(space / width));
  };
  const auto rows = [entries](std::size_t columns) { return (entries + columns - 1) / columns; };
  const Legend beside{fitting(beside_label), rows(fitting(beside_label)) - 1};
  const Legend below{fitting(panel_width), rows(fitting(panel_width))};
  return width <= beside_label && beside.rows <= below.rows ? beside : below;
}

Page single_page(std::span<const DrawnFigure> figures, std::span<const std::string> results) {
  const std::size_t columns = grid_columns(figures.size());
  Page page = empty_page(static_cast<double>(columns) * figure_width, results);
  for (std::size_t first = 0; first < figures.size(); first += columns) {
    const auto row = figures.subspan(first, std::min(columns, figures.size() - first));
    for (std::size_t i = 0; i < row.size(); ++i) {
      page.figures.push_back(place(row[i], first + i, static_cast<double>(i) * figure_width, page.height));
    }
    page.height += tallest(row);
  }
  return page;
}

std::vector<Page> separate_pages(std::span<const DrawnFigure> figures, std::span<const std::string> results) {
  std::vector<Page> pages;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    Page& page = pages.emplace_back(empty_page(figure_width, results));
    page.figures.push_back(place(figures[i], i, 0, page.height));
    page.height += tallest(figures);
  }
  return pages;
}

}  // namespace mbcc::figure
