// Pages: what `mbcc run --plot` and `mbcc plot` write into a file that ends in .html.

#include "page/page.hpp"

#include "fixture.hpp"

namespace mbcc::test {
namespace {

using Json = nlohmann::json;

constexpr const char* swing = R"(system swing
dimension 2
parameter pivot = 0
particle bob { mass = 1; position = (pivot, -1) }
gravity (0, -9.81)
constraint rod : norm(bob.position - (pivot, 0)) = 1
integrate { from = 0; to = 0.1; step = 0.01; method = rk4 }
)";

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t from = text.find(begin);
  REQUIRE(from != std::string::npos);
  return text.substr(from + begin.size(), text.find(end, from) - from - begin.size());
}

Json scene_of(const std::string& page) {
  return Json::parse(between(page, R"(<script id="data" type="application/json">)", "</script>"))["scene"];
}

std::string refusal(const std::vector<std::string>& arguments) {
  const Outcome outcome = run_mbcc(arguments);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.output.empty());
  return outcome.errors;
}

/// Whether there are pages; if not, mbcc has to say so.
bool has_pages() {
  if (!page::available()) {
    CHECK(refusal({"plot", "result.csv", "-o", "page.html"}) ==
          "mbcc: error: this mbcc was built without HTML pages: their libraries come by npm (in Debian the packages "
          "nodejs and npm), which was not there\n");
  }
  return page::available();
}

}  // namespace

TEST_CASE("a run becomes a page, its rods where the parameters put them") {
  if (!has_pages()) {
    return;
  }
  const Workshop shop;
  const std::string model = shop.write("swing.mbd", swing);
  const Outcome outcome = run_mbcc({"run", model, "--quiet", "--plot", shop.path("page.html"), "--set", "pivot=2.5"});
  CHECK(outcome.errors == "");
  CHECK(outcome.exit_code == 0);
  const std::string page = shop.read("page.html");
  CHECK(between(page, "<title>", "</title>") == "swing");
  CHECK(between(page, "<p class=\"facts\">", "</p>") == model + " · t = 0 to 0.1");
  const Json scene = scene_of(page);
  REQUIRE(scene["rods"].size() == 1);
  CHECK(scene["rods"][0]["point"] == 0);
  CHECK(scene["rods"][0]["anchor"] == Json{2.5, 0.0, 0.0});
  CHECK(page.find("constraint errors") != std::string::npos);
}

TEST_CASE("a recorded result becomes a page without rods") {
  if (!has_pages()) {
    return;
  }
  const Workshop shop;
  const std::string csv = shop.write("swing.csv", "t,x1,y1,vx1,vy1\n0,0,1,2,3\n1,1,2,3,4\n");
  const Outcome outcome = run_mbcc({"plot", csv, "-o", shop.path("page.html")});
  CHECK(outcome.errors == "");
  CHECK(outcome.exit_code == 0);
  CHECK(between(shop.read("page.html"), "<title>", "</title>") == "swing");
  const Json scene = scene_of(shop.read("page.html"));
  CHECK(scene["dimension"] == 2);
  CHECK(scene["points"].size() == 1);
  CHECK(scene["rods"].empty());
}

TEST_CASE("what cannot become a page is refused") {
  if (!has_pages()) {
    return;
  }
  const Workshop shop;
  const std::string csv = shop.write("result.csv", "t,x1\n0,0\n");
  CHECK(refusal({"plot", csv, csv, "-o", shop.path("page.html")}) ==
        "mbcc: error: a page shows one result, and these are 2\n");
  CHECK(refusal({"plot", csv, "-o", shop.path("nowhere/page.html")}) ==
        "mbcc: error: cannot write `" + shop.path("nowhere/page.html") + "`\n");
}

}  // namespace mbcc::test
