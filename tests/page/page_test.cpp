// The text of a page: its data block in full, and what stands around it.

#include "page/page.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "page/base64.hpp"

namespace mbcc::page {
namespace {

using Json = nlohmann::json;

figure::Table pendulum() {
  return {"pendulum.csv",
          {"t", "x1", "y1", "vx1", "vy1", "rod.position_error", "energy"},
          {{0, 1}, {0, 0.5}, {-1, -1}, {3, 3}, {0, 0.25}, {-1e-9, 0}, {-5, -4}}};
}

std::string page_of(const figure::Table& table) {
  return write_page(table, {{{"x1", std::nullopt, {0, 0, 0}}}, {0, 0, 1}}, "a <b> & c", "</script>.mbd");
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin) + begin.size();
  return text.substr(from, text.find(end, from) - from);
}

Json data_of(const std::string& page) {
  return Json::parse(between(page, R"(<script id="data" type="application/json">)", "</script>"));
}

}  // namespace

TEST_CASE("the page holds the columns and what to draw of them") {
  const auto column = [](const char* name, const std::vector<double>& values) {
    return Json{{"name", name}, {"values", base64(values)}};
  };
  const auto panel = [](const char* title, bool logarithmic, const std::vector<int>& columns) {
    return Json{{"title", title}, {"logarithmic", logarithmic}, {"columns", columns}};
  };
  const Json expected = {
      {"rows", 2},
      {"recorded", 2},
      {"columns",
       {column("t", {0, 1}), column("x1", {0, 0.5}), column("y1", {-1}), column("vx1", {3}), column("vy1", {0, 0.25}),
        column("rod", {1e-9, 0}), column("energy", {0, 1})}},
      {"figures",
       {{{"title", "particle 1"},
         {"panels", {panel("coordinates", false, {1, 2}), panel("velocities", false, {3, 4})}}},
        {{"title", "constraint errors"}, {"panels", Json::array({panel("of position", true, {5})})}},
        {{"title", "energy"}, {"panels", Json::array({panel("energy drift", false, {6})})}}}},
      {"scene",
       {{"dimension", 2},
        {"up", {0.0, 0.0, 1.0}},
        {"points", Json::array({{{"name", "particle 1"}, {"position", {1, 2}}, {"velocity", {3, 4}}}})},
        {"rods", Json::array({{{"point", 0}, {"anchor", {0.0, 0.0, 0.0}}, {"length", 1.0}}})},
        {"spheres", Json::array()}}}};
  CHECK(data_of(page_of(pendulum())) == expected);
}

TEST_CASE("names in the page stay text") {
  const std::string page = page_of(pendulum());
  CHECK(between(page, "<title>", "</title>") == "a &lt;b> &amp; c");
  CHECK(between(page, "<p class=\"facts\">", "</p>") == "&lt;/script>.mbd · t = 0 to 1");
  figure::Table hostile = pendulum();
  hostile.names.back() = "</script><script>alert(1)";
  CHECK(data_of(page_of(hostile))["columns"].back()["name"] == "</script><script>alert(1)");
}

TEST_CASE("a long result is thinned, and the page says so") {
  figure::Table table = pendulum();
  for (std::vector<double>& column : table.columns) {
    column.resize(100001, column.back());
  }
  for (std::size_t row = 0; row < table.columns[0].size(); ++row) {
    table.columns[0][row] = static_cast<double>(row);
    table.columns[1][row] = static_cast<double>(row % 17);
  }
  const std::string page = page_of(table);
  CHECK(data_of(page)["rows"] == 2501);
  CHECK(page.find("The page holds 2501 of the 100001 recorded rows") != std::string::npos);
  CHECK(page.find("t = 0 to 100000 · 2501 of 100001 rows</p>") != std::string::npos);
  CHECK(page.size() < 3000000);
  CHECK(page_of(pendulum()).find("The page holds all 2 recorded rows.") != std::string::npos);
}

}  // namespace mbcc::page
