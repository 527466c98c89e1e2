// Axes, thinning, legends and places.

#include "figure/drawing.hpp"

#include <cmath>
#include <limits>

#include "figure/layout.hpp"
#include "results.hpp"

namespace mbcc::test {
namespace {

using namespace figure;
using Curves = std::vector<std::vector<double>>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Axis values_axis(const Curves& curves, double extent = 0) { return axis_of(curves, Measure::Value, extent); }

std::string ends(const Axis& axis) {
  return fmt::format("{:.6g} {:.6g}{}", axis.low, axis.high, axis.logarithmic ? " log" : "");
}

/// `rows` rows of sin t, with one peak of 5 in the middle.
Table peaked(std::size_t rows) {
  std::string text = "t,x1\n";
  for (std::size_t i = 0; i < rows; ++i) {
    text += fmt::format("{},{}\n", i, i == rows / 2 ? 5 : std::sin(static_cast<double>(i)));
  }
  return table_of(text);
}

const Figure lone{"particle 1", {{"coordinates", Measure::Value, {{"x1", {"x1"}}}}}, {"x1"}, {}};

}  // namespace

TEST_CASE("an axis has room for its curves") {
  CHECK(ends(values_axis({{0, 1}, {not_a_number, -1, infinity}})) == "-1.12 1.12");
  CHECK(ends(axis_of(Curves{{0, 1e-15}}, Measure::Change, 1)) == "-6e-17 1.06e-15");
}

TEST_CASE("what does not move is a level line") {
  CHECK(ends(values_axis({{0, 0}})) == "-1 1");
  CHECK(ends(values_axis({{not_a_number}})) == "-1 1");
  CHECK(ends(values_axis({{4}})) == "2 6");
  CHECK(ends(values_axis({{-4, -4.000001}})) == "-6 -2");
  CHECK(ends(values_axis({{1e-14, -1e-14}}, 1)) == "-1 1");
  CHECK(ends(values_axis({{1e-9, -1e-9}}, 1)) == "-1.12e-09 1.12e-09");
}

TEST_CASE("an axis has few marks, at round numbers") {
  CHECK(values_axis({{0, 1}}).tick == 0.2);
  CHECK(values_axis({{-3, 3}}).tick == 1);
  CHECK(values_axis({{0, 2.5}}).tick == 0.5);
  CHECK(values_axis({{0, 8.5e-12}}).tick == Approx(2e-12).epsilon(1e-15));
}

TEST_CASE("an axis has the digits that its ends need") {
  CHECK(values_axis({{1, 2}}).digits == 6);
  CHECK(values_axis({{1000, 1000.01}}).digits == 7);
}

TEST_CASE("a logarithmic axis has whole decades, without the zeros that a curve goes through") {
  std::vector<double> dips(100, 3e-6);
  dips[50] = 1e-12;
  CHECK(ends(axis_of(Curves{dips, {0, 2e-5}}, Measure::Magnitude, 0)) == "1e-06 0.0001 log");
  CHECK(ends(axis_of(Curves{{1e-300, 1}}, Measure::Magnitude, 0)) == "1e-19 10 log");
  CHECK(ends(axis_of(Curves{{3, 4}}, Measure::Magnitude, 0)) == "0.1 10 log");
  CHECK(ends(axis_of(Curves{{0, 0}}, Measure::Magnitude, 0)) == "-1 1");
}

TEST_CASE("of many rows as many are left as a picture shows, peaks among them") {
  const std::vector<Table> results = {peaked(100001)};
  const DrawnFigure figure = draw(lone, results);
  const Line& line = figure.panels[0].lines[0];
  CHECK(line.values.size() <= 4 * 401);
  CHECK(line.time.front() == 0);
  CHECK(line.time.back() == 100000);
  CHECK(*std::max_element(line.values.begin(), line.values.end()) == 5);
  CHECK(*std::min_element(line.values.begin(), line.values.end()) < -0.999);
  CHECK(std::is_sorted(line.time.begin(), line.time.end()));
}

TEST_CASE("of few rows all are left") {
  const std::vector<Table> results = {peaked(1000)};
  CHECK(draw(lone, results).panels[0].lines[0].values == results[0].columns[1]);
}

TEST_CASE("few rows are joined smoothly, but not errors, nor around a gap") {
  const auto smooth = [](const std::string& text) {
    const std::vector<Table> results = {table_of(text)};
    return draw(figures_of(results).front(), results).panels[0].lines[0].smooth;
  };
  CHECK(smooth("t,x1\n0,1\n1,0\n2,1\n"));
  CHECK_FALSE(smooth("t,x1\n0,1\n1,0\n"));
  CHECK_FALSE(smooth("t,x1\n0,1\n1,nan\n2,1\n"));
  CHECK_FALSE(smooth("t,rod.velocity_error\n0,1\n1,0\n2,1\n"));
  const std::vector<Table> many = {peaked(401)};
  CHECK_FALSE(draw(lone, many).panels[0].lines[0].smooth);
}

TEST_CASE("errors of a constraint have one colour in all panels, and those that are zero say so") {
  const std::vector<Table> results = {
      table_of("t,skate.velocity_error,rod.position_error,rod.velocity_error\n0,0,1,2\n1,0,-1,2\n")};
  const DrawnFigure figure = draw(figures_of(results).front(), results);
  REQUIRE(figure.panels.size() == 2);
  CHECK(figure.panels[0].lines[0].title == "rod");
  CHECK(figure.panels[1].lines[0].title == "skate: 0");
  CHECK(figure.panels[1].lines[1].title == "rod");
  CHECK(figure.panels[0].lines[0].colour == figure.panels[1].lines[1].colour);
  CHECK(figure.panels[0].lines[0].colour != figure.panels[1].lines[0].colour);
}

TEST_CASE("a result that lacks a column lacks its line") {
  const std::vector<Table> results = {table_of("t,x1\n0,1\n"), table_of("t,x1,y1\n0,2,3\n")};
  const DrawnFigure figure = draw(figures_of(results).front(), results);
  const std::vector<Line>& lines = figure.panels[0].lines;
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].title == "x1");
  CHECK((lines[1].result == 1 && lines[1].colour == lines[0].colour && lines[1].title.empty()));
  CHECK((lines[2].result == 1 && lines[2].title == "y1"));
}

TEST_CASE("nothing on a page lies over another, or beyond its edge") {
  std::string names = "t", row = "0";
  for (int i = 1; i <= 7; ++i) {
    names += fmt::format(",x{0},vx{0},ax{0},a_rather_long_name_{0}.velocity_error,output{0}", i);
    row += ",1,1,1,1,1";
  }
  const std::vector<Table> results = {table_of(names + "\n" + row + "\n"), table_of("t,energy\n0,1\n")};
  const std::vector<std::string> titles(2, "result.csv");
  std::vector<DrawnFigure> figures;
  for (const Figure& figure : figures_of(results)) {
    figures.push_back(draw(figure, results));
  }
  std::vector<Page> pages = separate_pages(figures, titles);
  CHECK(pages.size() == figures.size());
  pages.push_back(single_page(figures, titles));
  CHECK(pages.back().figures.size() == figures.size());
  for (const Page& page : pages) {
    CHECK(page.results.size() == 2);
    std::vector<Box> boxes;
    for (const PlacedFigure& figure : page.figures) {
      CHECK(figure.title.top > page.results.back().top);
      CHECK(figure.title.top < figure.panels.front().top);
      boxes.insert(boxes.end(), figure.panels.begin(), figure.panels.end());
    }
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      CHECK((boxes[i].left > 0 && boxes[i].right < page.width && boxes[i].bottom < page.height));
      for (std::size_t j = 0; j < i; ++j) {
        CHECK((boxes[i].left > boxes[j].right || boxes[i].top > boxes[j].bottom || boxes[j].left > boxes[i].right ||
               boxes[j].top > boxes[i].bottom));
      }
    }
  }
}

}  // namespace mbcc::test
