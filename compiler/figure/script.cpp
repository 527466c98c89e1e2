#include "figure/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "emit/templates.hpp"
#include "figure/drawing.hpp"
#include "figure/layout.hpp"
#include "figure/template.hpp"

namespace mbcc::figure {

namespace {

/// Those of templates/figure.gp.in. The last one is grey; dash patterns are explained in it.
constexpr std::size_t line_colours = 7;
constexpr std::size_t pale = 10;  // how far behind a line type its pale, broad one is
constexpr std::size_t first_result_label = 11;

/// A text between single quotes, where gnuplot takes every letter for itself, joined to what it has of single quotes:
/// two that follow each other, as in `theta''`, it does not read there.
std::string quoted(std::string_view text) {
  std::string result = "'";
  for (const char letter : text) {
    result += letter == '\'' ? std::string("'.\"'\".'") : std::string(1, letter);
  }
  return result + "'";
}

std::string data_block(const std::string& name, const Line& line) {
  std::string text = name + " << EOD\n";
  const auto number = [](double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : "NaN"; };
  for (std::size_t i = 0; i < line.time.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{} {}\n", number(line.time[i]), number(line.values[i]));
  }
  return text + "EOD\n";
}

std::string scale(const Axis& axis) {
  const std::string range = fmt::format("set yrange [{:.9g}:{:.9g}]", axis.low, axis.high);
  return axis.logarithmic ? range + "; set logscale y; set format y '10^{%T}'; set ytics autofreq"
                          : range + fmt::format("; unset logscale y; set format y '%.{}g'; set ytics {:.9g}",
                                                axis.digits, axis.tick);
}

/// Where a panel stands, and what is around it.
std::string frame(const DrawnPanel& panel, const Page& page, const Box& box, bool lowest) {
  const Legend legend = legend_of(panel);
  return fmt::format(
      "set lmargin at screen {:.5f}; set rmargin at screen {:.5f}\n"
      "set tmargin at screen {:.5f}; set bmargin at screen {:.5f}\n"
      "set label 1 {} noenhanced at graph 0, graph 1 offset character 0, {:.2f} textcolor rgb '#444444'\n"
      "set key at graph 1, graph 1 right bottom maxcols {}\n"
      "{}\n"
      "{}\n",
      box.left / page.width, box.right / page.width, 1 - box.top / page.height, 1 - box.bottom / page.height,
      quoted(panel.label), 0.5 + 0.95 * static_cast<double>(legend.rows), legend.columns, scale(panel.axis),
      lowest ? "set format x '%g'; set xlabel 't' offset 0, 0.5" : "set format x ''; unset xlabel");
}

/// The lines of a panel; their data are the blocks behind number `block`. Of several results the first lies broad and
/// pale under the others, so that results that agree are all seen.
std::string plot(const DrawnPanel& panel, bool several, std::size_t block) {
  std::vector<std::string> parts, legend;
  for (const Line& line : panel.lines) {
    const std::size_t type = line.colour % line_colours + 1;
    const std::string title = line.title.empty() ? "notitle" : "title " + quoted(line.title);
    parts.push_back(fmt::format("$data_{} {}with lines linetype {} dashtype {}{} {}", ++block,
                                line.smooth ? "smooth mcsplines " : "",
                                several && line.result == 0 ? type + pale : type, line.result + 1,
                                panel.axis.logarithmic ? " linewidth 1" : "", several ? "notitle" : title));
    if (several && !line.title.empty()) {
      legend.push_back(fmt::format("keyentry with lines linetype {} {}", type, title));
    }
  }
  parts.insert(parts.end(), legend.begin(), legend.end());
  return fmt::format("plot {}\n", fmt::join(parts, ", \\\n     "));
}

/// The dash patterns of the results and their names.
std::string results_legend(const Page& page, std::span<const std::string> results) {
  std::string text;
  for (std::size_t i = 0; i < page.results.size(); ++i) {
    const Point at{page.results[i].left / page.width, 1 - page.results[i].top / page.height};
    const double begin = (page.results[i].left - sample_length) / page.width;
    fmt::format_to(std::back_inserter(text),
                   "set arrow {0} from screen {1:.5f}, screen {2:.5f} to screen {3:.5f}, screen {2:.5f} nohead "
                   "linetype {4} dashtype {0}\n"
                   "set label {5} {6} noenhanced at screen {3:.5f}, screen {2:.5f} offset 0.6, 0\n",
                   i + 1, begin, at.top, at.left, line_colours + (i == 0 ? pale : 0), first_result_label + i,
                   quoted(results[i]));
  }
  return text;
}

std::string write_page(std::span<const DrawnFigure> figures, const Page& page, std::span<const std::string> results,
                       std::size_t& block) {
  std::string text = "set multiplot\n" + results_legend(page, results);
  for (const PlacedFigure& placed : page.figures) {
    const DrawnFigure& figure = figures[placed.index];
    fmt::format_to(std::back_inserter(text),
                   "\nset label 2 {} noenhanced at screen {:.5f}, screen {:.5f} font ',13' textcolor rgb '#000000'\n",
                   quoted(figure.title), placed.title.left / page.width, 1 - placed.title.top / page.height);
    for (std::size_t i = 0; i < figure.panels.size(); ++i) {
      const DrawnPanel& panel = figure.panels[i];
      text += frame(panel, page, placed.panels[i], i + 1 == figure.panels.size());
      text += plot(panel, results.size() > 1, block);
      block += panel.lines.size();
      text += "unset label\nunset arrow\n";  // what a page says once is said with its first panel
    }
  }
  return text + "unset multiplot\n";
}

std::string write_data(std::span<const DrawnFigure> figures) {
  std::string text;
  std::size_t block = 0;
  for (const DrawnFigure& figure : figures) {
    for (const DrawnPanel& panel : figure.panels) {
      for (const Line& line : panel.lines) {
        text += data_block(fmt::format("$data_{}", ++block), line);
      }
    }
  }
  return text;
}

/// The time that all results together take; a single row has some space around it.
std::string time_range(std::span<const Table> results) {
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (const Table& result : results) {
    const auto [first, last] = std::minmax_element(result.time().begin(), result.time().end());
    from = std::min(from, *first);
    to = std::max(to, *last);
  }
  return to > from ? fmt::format("[{:.9g}:{:.9g}]", from, to) : fmt::format("[{:.9g}:{:.9g}]", from - 0.5, from + 0.5);
}

std::string terminal(Format format, const Page& page) {
  switch (format) {
    case Format::Svg:
      return fmt::format("svg size {:.0f}, {:.0f} dynamic font 'Helvetica, Arial, sans-serif, 10' background 'white'",
                         page.width, page.height);
    case Format::Png:  // twice as many pixels, for sharp letters
      return fmt::format("pngcairo size {:.0f}, {:.0f} font 'Sans, 10' fontscale 2 linewidth 2 dashlength 2",
                         2 * page.width, 2 * page.height);
    case Format::Pdf:  // 72 points are an inch
      return fmt::format("pdfcairo size {:.3f}, {:.3f} font 'Sans, 10' fontscale 0.8", page.width / 72,
                         page.height / 72);
  }
  return {};
}

}  // namespace

std::string gnuplot_script(std::span<const Table> results, Format format, const std::string& output) {
  std::vector<DrawnFigure> figures;
  for (const Figure& figure : figures_of(results)) {
    figures.push_back(draw(figure, results));
  }
  std::vector<std::string> names;
  for (const Table& result : results) {
    names.push_back(result.name);
  }
  const std::vector<Page> pages =
      format == Format::Pdf ? separate_pages(figures, names) : std::vector{single_page(figures, names)};
  std::string text;
  std::size_t block = 0;
  for (const Page& page : pages) {
    text += write_page(figures, page, names, block);
  }
  return cpp::fill(template_text("figure.gp.in"), {{"terminal", terminal(format, pages.front())},
                                                   {"output", quoted(output)},
                                                   {"data", write_data(figures)},
                                                   {"time_range", time_range(results)},
                                                   {"pages", text}});
}

}  // namespace mbcc::figure
