// Figures: what `mbcc plot` and `mbcc run --plot` draw, and what they say if they cannot.

#include <algorithm>

#include "fixture.hpp"

namespace mbcc::test {
namespace {

constexpr const char* result = "t,x1,vx1,ax1\n0,0,1,0\n1,1,1,0\n2,2,1,0\n";

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// The files in the workshop, but for the cache.
std::vector<std::string> files(const Workshop& shop) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(shop.directory / ".")) {
    if (entry.is_regular_file()) {
      names.push_back(entry.path().filename());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string refusal(const std::vector<std::string>& arguments) {
  const Outcome outcome = run_mbcc(arguments);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.output.empty());
  return outcome.errors;
}

/// A directory that holds a gnuplot of this text alone.
std::string path_with_gnuplot(const Workshop& shop, const std::string& text) {
  std::filesystem::create_directory(shop.directory / "bin");
  const std::string program = shop.write("bin/gnuplot", text);
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  return shop.path("bin");
}

bool has_gnuplot() { return run_program("gnuplot", {"--version"}).exit_code == 0; }

constexpr const char* no_gnuplot =
    "mbcc: error: figures are drawn by gnuplot, which is not installed (in Debian it is the package gnuplot-nox); a "
    "name that ends in `.gp` gets its script\n";

}  // namespace

TEST_CASE("gnuplot draws every form of picture, and nothing stays beside it") {
  if (!has_gnuplot()) {
    WARN("not tested: Debian's gnuplot-nox is not installed");
    return;
  }
  const Workshop shop;
  const std::string csv = shop.write("result.csv", result);
  for (const std::string ending : {"svg", "png", "pdf"}) {
    const std::string figure = "figure." + ending;
    const Outcome outcome = run_mbcc({"plot", csv, "-o", shop.path(figure)});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.output.empty());
    CHECK(outcome.errors.empty());
    CHECK(files(shop) == std::vector{figure, std::string("result.csv")});
    const std::string picture = shop.read(figure);
    CHECK(picture.size() > 5000);
    CHECK(picture.substr(0, 4) == (ending == "svg" ? "<?xm" : ending == "png" ? "\x89PNG" : "%PDF"));
    CHECK((ending != "svg" || (contains(picture, "particle 1") && contains(picture, "</svg>"))));
    std::filesystem::remove(shop.path(figure));
  }
}

TEST_CASE("gnuplot draws what is nowhere, or never changes") {
  if (!has_gnuplot()) {
    WARN("not tested: Debian's gnuplot-nox is not installed");
    return;
  }
  const Workshop shop;
  const std::string csv = shop.write("result.csv",
                                     "t,x1,nowhere,there's,rod.velocity_error,energy\n"
                                     "3,0,nan,1e-300,0,-1e300\n");
  const Outcome outcome = run_mbcc({"plot", csv, "-o", shop.path("figure.svg")});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.errors.empty());
  CHECK(contains(shop.read("figure.svg"), "there's"));
}

TEST_CASE("without gnuplot it is said what to install, before anything is run") {
  const Workshop shop;
  const std::string csv = shop.write("result.csv", result);
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const Variable path("PATH", shop.path("nothing"));
  CHECK(refusal({"plot", csv, "-o", shop.path("figure.svg")}) == no_gnuplot);
  CHECK(refusal({"run", model, "--plot", shop.path("figure.svg")}) == no_gnuplot);
  CHECK(run_mbcc({"plot", csv, "-o", shop.path("figure.gp")}).exit_code == 0);
  CHECK(files(shop) == std::vector<std::string>{"figure.gp", "pendulum.mbd", "result.csv"});
}

TEST_CASE("what gnuplot says is shown if it fails, and the old figure stays") {
  const Workshop shop;
  const std::string csv = shop.write("result.csv", result);
  const std::string figure = shop.write("figure.svg", "old");
  for (const std::string text : {"#!/bin/sh\necho no terminal >&2\nexit 1\n", "#!/bin/sh\necho no terminal\n"}) {
    const Variable path("PATH", path_with_gnuplot(shop, text));
    CHECK(refusal({"plot", csv, "-o", figure}) ==
          "mbcc: error: gnuplot could not draw `" + figure + "`: no terminal\n");
  }
  CHECK(shop.read("figure.svg") == "old");
  CHECK(files(shop) == std::vector<std::string>{"figure.svg", "result.csv"});
}

TEST_CASE("the script draws a picture of its own name") {
  const Workshop shop;
  const std::string csv = shop.write("result.csv", result);
  REQUIRE(run_mbcc({"plot", csv, "-o", shop.path("figure.gp")}).exit_code == 0);
  CHECK(contains(shop.read("figure.gp"), "set output '" + shop.path("figure.svg") + "'\n"));
}

TEST_CASE("a figure that cannot be is refused") {
  const Workshop shop;
  const std::string csv = shop.write("result.csv", result);
  const std::string figure = shop.path("figure.gp");
  const std::string usage =
      "mbcc: error: `mbcc plot` takes results and where to draw them: `mbcc plot RESULT.csv ... -o FIGURE`\n";
  CHECK(refusal({"plot"}) == usage);
  CHECK(refusal({"plot", csv}) == usage);
  CHECK(refusal({"plot", "-o", figure}) == usage);
  CHECK(refusal({"plot", csv, "-o", "figure.jpg"}) ==
        "mbcc: error: which form of figure is `figure.jpg`: its name must end in `.svg`, `.png`, `.pdf`, `.gp` or "
        "`.html`\n");
  CHECK(
      refusal({"run", shop.path("none.mbd"), "--plot", "figure"}) ==
      "mbcc: error: which form of figure is `figure`: its name must end in `.svg`, `.png`, `.pdf`, `.gp` or `.html`\n");
  CHECK(refusal({"plot", csv, csv, csv, csv, csv, csv, "-o", figure}) ==
        "mbcc: error: one figure shows at most 5 results, and these are 6\n");
  CHECK(refusal({"plot", shop.path("none.csv"), "-o", figure}) ==
        "mbcc: error: cannot read `" + shop.path("none.csv") + "`\n");
  const std::string empty = shop.write("empty.csv", "t,x1\n");
  CHECK(refusal({"plot", csv, empty, "-o", figure}) == empty + ":2:1: error: the result has no rows\n\n^\n");
  const std::string huge = shop.write("huge.csv", "t,x1\n");
  std::filesystem::resize_file(huge, std::uintmax_t{1} << 32);  // takes no space: it is a hole
  CHECK(refusal({"plot", huge, "-o", figure}) ==
        "mbcc: error: `" + huge + "` is larger than four gigabytes: `--every` records fewer rows\n");
  const std::string time = shop.write("time.csv", "t\n0\n");
  CHECK(refusal({"plot", time, "-o", figure}) ==
        "mbcc: error: there is nothing to draw: `" + time + "` holds the time alone\n");
  CHECK(refusal({"plot", csv, "-o", shop.path("no/such/figure.gp")}) ==
        "mbcc: error: cannot write `" + shop.path("no/such/figure.gp") + "`\n");
  const Variable path("PATH", path_with_gnuplot(shop, "#!/bin/sh\n"));
  CHECK(refusal({"plot", csv, "-o", shop.path("no/such/figure.svg")}) ==
        "mbcc: error: cannot write `" + shop.path("no/such/figure.svg") + "`\n");
  CHECK(files(shop) == std::vector<std::string>{"empty.csv", "huge.csv", "result.csv", "time.csv"});
}

TEST_CASE("a run with --plot draws errors and energy too, and leaves nothing but the figure") {
  const Workshop shop;
  const Variable compiler("CXX", "/nonexistent/c++");
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const Outcome outcome = run_mbcc({"run", model, "--plot", shop.path("figure.gp"), "--to", "0.05"});
  CHECK(outcome.exit_code == 0);
  CHECK(contains(outcome.output, "pendulum: ok"));
  const std::string script = shop.read("figure.gp");
  for (const std::string part : {"bob", "coordinates", "constraint errors", "energy drift", "\n0.05 "}) {
    INFO(part);
    CHECK(contains(script, part));
  }
  CHECK(files(shop) == std::vector<std::string>{"figure.gp", "pendulum.mbd"});
}

TEST_CASE("a compiled run is drawn as well, from the user's own recording if there is one") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  for (const std::vector<std::string>& recording :
       std::vector<std::vector<std::string>>{{"--csv", shop.path("own.csv")}, {"--csv=" + shop.path("own.csv")}}) {
    std::vector<std::string> arguments = {"run", model, "--cxxflags=-O0", "--quiet", "--plot", shop.path("figure.gp")};
    arguments.insert(arguments.end(), recording.begin(), recording.end());
    CHECK(run_mbcc(arguments).exit_code == 0);
    CHECK(contains(shop.read("own.csv"), "rod.acceleration_error,energy\n"));
    CHECK(contains(shop.read("figure.gp"), "energy drift"));
    CHECK(files(shop) == std::vector<std::string>{"figure.gp", "own.csv", "pendulum.mbd"});
    std::filesystem::remove(shop.path("figure.gp"));
  }
}

TEST_CASE("a recording that is no file cannot be drawn") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  for (const std::string place : {"-", "/dev/null"}) {
    CHECK(refusal({"run", model, "--plot", shop.path("figure.gp"), "--csv", place}) ==
          "mbcc: error: `--plot` draws what `--csv` records, and `" + place + "` is no file\n");
  }
}

TEST_CASE("a run that fails keeps its exit code, and is drawn as far as it came") {
  const Workshop shop;
  const Variable compiler("CXX", "/nonexistent/c++");
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const std::string falls = shop.write("falls.mbd",
                                       "dimension 1\nparticle 1 { mass = 1; position = 1; force = ln(0.01 - t) }\n"
                                       "integrate { to = 1; step = 0.001; method = rk4 }\n");
  CHECK(run_mbcc({"run", model, "--plot", shop.path("figure.gp"), "--initial", "bob.x=2"}).exit_code == 3);
  CHECK(run_mbcc({"run", model, "--plot", shop.path("figure.gp"), "--set", "h=2"}).exit_code == 2);
  CHECK_FALSE(shop.has("figure.gp"));
  CHECK(run_mbcc({"run", falls, "--plot", shop.path("figure.gp")}).exit_code == 3);
  CHECK(contains(shop.read("figure.gp"), "particle 1"));
  CHECK(files(shop) == std::vector<std::string>{"falls.mbd", "figure.gp", "pendulum.mbd"});
}

}  // namespace mbcc::test
