// Which figures and panels a result is shown in.

#include "figure/panels.hpp"

#include "results.hpp"

namespace mbcc::test {
namespace {

using namespace figure;
using Names = std::vector<std::string>;

/// One line for each panel: "figure | panel: curve = columns; ...", Magnitude in bars, Change with a delta.
std::string outline(const std::vector<Figure>& figures) {
  std::string text;
  for (const Figure& figure : figures) {
    for (const Panel& panel : figure.panels) {
      text += figure.title + " | " + panel.label + (panel.measure == Measure::Change ? " (change):" : ":");
      for (const Curve& curve : panel.curves) {
        text += panel.measure == Measure::Magnitude ? " |" + curve.label + "|" : " " + curve.label;
        text += curve.columns.size() == 1 ? "" : "=" + std::to_string(curve.columns.size()) + " columns";
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace

TEST_CASE("each particle has a figure of three panels") {
  CHECK(outline(figures_of(Names{"t", "x1", "y1", "x2", "y2", "bob.x", "p[1,2].x", "vx1", "vy1", "vx2", "vy2", "bob.vx",
                                 "p[1,2].vx", "ax1", "ay1", "ax2", "ay2", "bob.ax", "p[1,2].ax"})) ==
        "particle 1 | coordinates: x1 y1\n"
        "particle 1 | velocities: vx1 vy1\n"
        "particle 1 | accelerations: ax1 ay1\n"
        "particle 2 | coordinates: x2 y2\n"
        "particle 2 | velocities: vx2 vy2\n"
        "particle 2 | accelerations: ax2 ay2\n"
        "bob | coordinates: bob.x\n"
        "bob | velocities: bob.vx\n"
        "bob | accelerations: bob.ax\n"
        "p[1,2] | coordinates: p[1,2].x\n"
        "p[1,2] | velocities: p[1,2].vx\n"
        "p[1,2] | accelerations: p[1,2].ax\n");
}

TEST_CASE("errors of constraints are magnitudes, at each level that a constraint has") {
  CHECK(outline(figures_of(Names{"t", "rod.position_error", "rod.velocity_error", "rod.acceleration_error",
                                 "pin.x.velocity_error", "pin.x.acceleration_error"})) ==
        "constraint errors | of position: |rod|\n"
        "constraint errors | of velocity: |rod| |pin.x|\n"
        "constraint errors | of acceleration: |rod| |pin.x|\n");
}

TEST_CASE("of many constraints the largest error is shown") {
  Names names{"t"};
  for (int i = 1; i <= 8; ++i) {
    names.push_back("rod[" + std::to_string(i) + "].velocity_error");
  }
  CHECK(outline(figures_of(names)) == "constraint errors | of velocity: |largest of 8|=8 columns\n");
}

TEST_CASE("energy and outputs have a panel each, three to a figure") {
  CHECK(outline(figures_of(Names{"t", "energy"})) == "energy | energy drift (change): energy\n");
  CHECK(outline(figures_of(Names{"t", "height", "pace", "x12y", "pull", "energy"})) ==
        "energy and outputs | energy drift (change): energy\n"
        "energy and outputs | height: height\n"
        "energy and outputs | pace: pace\n"
        "outputs | x12y: x12y\n"
        "outputs | pull: pull\n");
  CHECK(figures_of(Names{"t"}).empty());
}

TEST_CASE("results of several models are shown together") {
  const std::vector<Table> tables = {table_of("t,x1,vx1\n0,1,2\n"), table_of("t,x1,angle\n0,1,2\n")};
  CHECK(outline(figures_of(tables)) ==
        "particle 1 | coordinates: x1\n"
        "particle 1 | velocities: vx1\n"
        "outputs | angle: angle\n");
}

TEST_CASE("samples are what the panel shows of the columns") {
  const Table table = table_of("t,a,b\n0,-3,1\n1,2,-5\n");
  CHECK(samples(table, Measure::Value, {"a", {"a"}}) == std::vector<double>{-3, 2});
  CHECK(samples(table, Measure::Change, {"a", {"a"}}) == std::vector<double>{0, 5});
  CHECK(samples(table, Measure::Magnitude, {"largest", {"a", "b"}}) == std::vector<double>{3, 5});
  CHECK(samples(table, Measure::Value, {"c", {"c"}}).empty());
}

}  // namespace mbcc::test
