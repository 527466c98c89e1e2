#include "figure/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace mbcc::figure {

namespace {

constexpr std::size_t stretches = 400;  // of points from left to right, a panel has little more

/// Note [few rows].
bool is_smooth(const std::vector<double>& values, Measure measure) {
  return measure != Measure::Magnitude && values.size() > 2 && values.size() <= stretches &&
         std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
}

/// Rows that show all of a curve: of each stretch the first, the last, the lowest and the highest; of magnitudes the
/// highest alone.
std::vector<std::size_t> visible_rows(const std::vector<double>& values, Measure measure) {
  const bool all_sides = measure != Measure::Magnitude;
  std::vector<std::size_t> rows;
  if (values.size() <= stretches * (all_sides ? 4 : 1)) {
    rows.resize(values.size());
    std::iota(rows.begin(), rows.end(), std::size_t{0});
    return rows;
  }
  const std::size_t length = (values.size() + stretches - 1) / stretches;
  for (std::size_t begin = 0; begin < values.size(); begin += length) {
    const std::size_t end = std::min(begin + length, values.size());
    const auto [low, high] = std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                                 values.begin() + static_cast<std::ptrdiff_t>(end));
    const auto lowest = static_cast<std::size_t>(low - values.begin());
    const auto highest = static_cast<std::size_t>(high - values.begin());
    std::vector<std::size_t> stretch = all_sides ? std::vector{begin, lowest, highest, end - 1} : std::vector{highest};
    std::sort(stretch.begin(), stretch.end());
    rows.insert(rows.end(), stretch.begin(), std::unique(stretch.begin(), stretch.end()));
  }
  return rows;
}

std::vector<double> pick(std::span<const double> values, const std::vector<std::size_t>& rows) {
  std::vector<double> picked;
  std::transform(rows.begin(), rows.end(), std::back_inserter(picked), [&](std::size_t row) { return values[row]; });
  return picked;
}

/// Not where the label of the panel has named its curve already.
bool has_legend(const Panel& panel) {
  return panel.measure != Measure::Change && panel.curves.front().label != panel.label;
}

/// `bob.x` under the title `bob` is x.
std::string beside_title(const std::string& label, const std::string& title) {
  return label.starts_with(title + ".") ? label.substr(title.size() + 1) : label;
}

double extent_of(const Figure& figure, std::span<const Table> results) {
  double extent = 0;
  for (const Panel& panel : figure.panels) {
    for (const Curve& curve : panel.curves) {
      for (const Table& result : results) {
        extent = largest_magnitude(samples(result, panel.measure, curve), extent);
      }
    }
  }
  return extent;
}

/// Draws the panels of one figure.
class Pen {
 public:
  Pen(const Figure& figure, std::span<const Table> results)
      : title_(figure.title), results_(results), extent_(extent_of(figure, results)) {}

  DrawnPanel draw(const Panel& panel) {
    DrawnPanel drawn{panel.label, {}, {}};
    std::vector<std::vector<double>> all;
    std::vector<std::size_t> still;  // lines that begin curves which are zero throughout
    for (std::size_t curve = 0; curve < panel.curves.size(); ++curve) {
      const std::size_t first = drawn.lines.size();
      double largest = 0;
      for (std::size_t result = 0; result < results_.size(); ++result) {
        std::vector<double> values = samples(results_[result], panel.measure, panel.curves[curve]);
        if (!values.empty()) {
          const std::vector<std::size_t> rows = visible_rows(values, panel.measure);
          drawn.lines.push_back({pick(results_[result].time(), rows),
                                 pick(values, rows),
                                 colour(panel, curve),
                                 result,
                                 is_smooth(values, panel.measure),
                                 {}});
          largest = largest_magnitude(values, largest);
          all.push_back(std::move(values));
        }
      }
      if (has_legend(panel)) {
        drawn.lines[first].title = beside_title(panel.curves[curve].label, title_);
      }
      if (largest == 0) {
        still.push_back(first);
      }
    }
    drawn.axis = axis_of(all, panel.measure, extent_);
    for (const std::size_t line : still) {  // no logarithmic axis has a place for zero
      drawn.lines[line].title += drawn.axis.logarithmic ? ": 0" : "";
    }
    std::stable_sort(drawn.lines.begin(), drawn.lines.end(),
                     [](const Line& a, const Line& b) { return a.result < b.result; });
    return drawn;
  }

 private:
  std::size_t colour(const Panel& panel, std::size_t curve) {
    if (panel.measure != Measure::Magnitude) {
      return curve;
    }
    const std::string& constraint = panel.curves[curve].label;
    const auto found = std::find(constraints_.begin(), constraints_.end(), constraint);
    const auto colour = static_cast<std::size_t>(found - constraints_.begin());
    if (found == constraints_.end()) {
      constraints_.push_back(constraint);
    }
    return colour;
  }

  const std::string& title_;
  std::span<const Table> results_;
  double extent_;
  std::vector<std::string> constraints_;  // in the order of their colours
};

}  // namespace

DrawnFigure draw(const Figure& figure, std::span<const Table> results) {
  DrawnFigure drawn{figure.title, {}};
  Pen pen(figure, results);
  for (const Panel& panel : figure.panels) {
    drawn.panels.push_back(pen.draw(panel));
  }
  return drawn;
}

}  // namespace mbcc::figure
