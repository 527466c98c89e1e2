#include "page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "emit/emit.hpp"
#include "emit/templates.hpp"
#include "figure/panels.hpp"
#include "page/base64.hpp"
#include "page/parts.hpp"
#include "page/thin.hpp"

namespace mbcc::page {

namespace {

using Json = nlohmann::ordered_json;

// A value takes 10.7 characters: 160,000 of them and the libraries make 2.4 MB. More than 2,500 rows are no better to
// look at: from four rows a pixel on, and a panel has some 700 pixels, the plots join them to bars, which looks ragged.
constexpr std::size_t most_values = 160000;
constexpr std::size_t most_rows = 2500;
constexpr std::size_t fewest_rows = 250;

/// What is drawn of a table: columns, each once, and the figures as indices into them.
struct Drawing {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  Json figures = Json::array();
};

class DrawingMaker {
 public:
  explicit DrawingMaker(const figure::Table& table) : table_(table) {
    add(figure::Measure::Value, {table.names.front(), {table.names.front()}});
  }

  Drawing make(std::span<const figure::Figure> figures) {
    for (const figure::Figure& figure : figures) {
      Json panels = Json::array();
      for (const figure::Panel& panel : figure.panels) {
        Json columns = Json::array();
        for (const figure::Curve& curve : panel.curves) {
          columns.push_back(add(panel.measure, curve));
        }
        const bool logarithmic = panel.measure == figure::Measure::Magnitude;
        panels.push_back({{"title", panel.label}, {"logarithmic", logarithmic}, {"columns", columns}});
      }
      drawing_.figures.push_back({{"title", figure.title}, {"panels", panels}});
    }
    return std::move(drawing_);
  }

 private:
  std::size_t add(figure::Measure measure, const figure::Curve& curve) {
    drawing_.names.push_back(curve.label);
    drawing_.columns.push_back(figure::samples(table_, measure, curve));
    return drawing_.names.size() - 1;
  }

  const figure::Table& table_;
  Drawing drawing_;
};

std::size_t rows_wanted(std::size_t columns) { return std::clamp(most_values / columns, fewest_rows, most_rows); }

/// The kept rows of a column; of one that never changes, a single value.
std::string encode(const std::vector<double>& column, const std::vector<std::size_t>& rows) {
  std::vector<double> kept;
  for (const std::size_t row : rows) {
    kept.push_back(column[row]);
  }
  const bool constant = std::all_of(kept.begin(), kept.end(), [&](double value) { return value == kept.front(); });
  return base64(std::span(kept).first(constant ? 1 : kept.size()));
}

Json indices_of(const std::vector<std::string>& columns, const std::vector<std::string>& names) {
  Json indices = Json::array();
  for (const std::string& column : columns) {
    indices.push_back(std::find(names.begin(), names.end(), column) - names.begin());
  }
  return indices;
}

Json describe(const Scene& scene, const std::vector<std::string>& names) {
  Json points = Json::array();
  for (const Point& point : scene.points) {
    points.push_back({{"name", point.name},
                      {"position", indices_of(point.position, names)},
                      {"velocity", indices_of(point.velocity, names)}});
  }
  Json rods = Json::array();
  for (const Rod& rod : scene.rods) {
    Json end = rod.other ? Json{{"other", *rod.other}} : Json{{"anchor", rod.anchor}};
    end.update({{"point", rod.point}, {"length", rod.length}});
    rods.push_back(std::move(end));
  }
  Json spheres = Json::array();
  for (const Sphere& sphere : scene.spheres) {
    spheres.push_back({{"centre", sphere.centre}, {"radius", sphere.radius}});
  }
  return {{"dimension", scene.dimension}, {"up", scene.up}, {"points", points}, {"rods", rods}, {"spheres", spheres}};
}

/// `text` with `from` written as `to`.
std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
  return text;
}

/// `text` as it stands between tags.
std::string escaped(const std::string& text) { return replaced(replaced(text, "&", "&amp;"), "<", "&lt;"); }

/// What the page's script reads: README.md tells its form.
Json data_of(const figure::Table& table, const Skeleton& skeleton) {
  const std::vector<figure::Figure> figures = figure::figures_of(table.names);
  const Drawing drawing = DrawingMaker(table).make(figures);
  const std::vector<std::size_t> rows = thin(drawing.columns, rows_wanted(drawing.columns.size()));
  Json columns = Json::array();
  for (std::size_t i = 0; i < drawing.columns.size(); ++i) {
    columns.push_back({{"name", drawing.names[i]}, {"values", encode(drawing.columns[i], rows)}});
  }
  return {{"rows", rows.size()},
          {"recorded", table.time().size()},
          {"figures", drawing.figures},
          {"scene", describe(scene_of(table, figures, skeleton), drawing.names)},
          {"columns", columns}};
}

}  // namespace

bool available() { return !part("page.js").empty(); }

std::string write_page(const figure::Table& table, const Skeleton& skeleton, const std::string& title,
                       const std::string& source) {
  const Json data = data_of(table, skeleton);
  const std::size_t recorded = table.time().size();
  const auto held = data["rows"].get<std::size_t>();
  std::string facts = fmt::format("{} · t = {} to {}", source, table.time().front(), table.time().back());
  std::string rows = fmt::format("The page holds all {} recorded rows.", recorded);
  if (held < recorded) {
    facts += fmt::format(" · {} of {} rows", held, recorded);
    rows = fmt::format(
        "The page holds {} of the {} recorded rows, each with all its digits: the first of every stretch, and the one "
        "that stands out most.",
        held, recorded);
  }
  return cpp::fill(part("page.html.in"), {{"title", escaped(title)},
                                          {"facts", escaped(facts)},
                                          {"rows", rows},
                                          {"generator", fmt::format("mbcc {}", version)},
                                          {"licences", escaped(std::string(part("licences.txt")))},
                                          {"style", std::string(part("page.css"))},
                                          {"data", replaced(data.dump(), "<", "\\u003c")},
                                          {"script", std::string(part("page.js"))}});
}

}  // namespace mbcc::page
