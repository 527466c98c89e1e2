// `mbcc run`: the compiler it uses, the cache, and the interpreter.

#include <fmt/format.h>

#include "fixture.hpp"

namespace mbcc::test {
namespace {

/// A compiler that writes a line into `log` whenever it is asked, and then does what the real one does.
std::string counting_compiler(const Workshop& shop) {
  const std::string script =
      shop.write("counting-c++", "#!/bin/sh\necho \"$@\" >>" + quoted(shop.path("log")) + "\nexec c++ \"$@\"\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  return script;
}

std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace

TEST_CASE("the second run of a model does not compile it again") {
  const Workshop shop;
  const Variable compiler("CXX", counting_compiler(shop));
  const std::string model = shop.write("pendulum.mbd", pendulum);
  CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0"}).exit_code == 0);
  CHECK(lines(shop.read("log")) == 1);
  CHECK(shop.read("log").find("-std=c++20 -O0 ") == 0);
  CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0"}).exit_code == 0);
  CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0", "--set", "g=1.62"}).exit_code == 0);
  CHECK(lines(shop.read("log")) == 1);

  CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0 -g"}).exit_code == 0);  // other flags, another program
  CHECK(lines(shop.read("log")) == 2);
  shop.write("pendulum.mbd", std::string(pendulum) + "output angle = atan2(bob.x, -bob.y)\n");
  CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0"}).exit_code == 0);
  CHECK(lines(shop.read("log")) == 3);
}

TEST_CASE("without --cxxflags a run is optimised for this machine") {
  const Workshop shop;
  const Variable compiler("CXX", counting_compiler(shop));
  CHECK(run_mbcc({"run", shop.write("pendulum.mbd", pendulum), "--quiet"}).exit_code == 0);
  CHECK(shop.read("log").find("-std=c++20 -O3 -march=native ") == 0);
}

TEST_CASE("a run takes the program's flags and gives its exit code") {
  const Workshop shop;
  const Variable compiler("CXX", "/nonexistent/c++");
  const std::string model = shop.write("pendulum.mbd", pendulum);
  CHECK(run_mbcc({"run", model, "--set", "gg=1"}).exit_code == 2);
  CHECK(run_mbcc({"run", model, "--initial", "bob.x=2"}).exit_code == 3);
  const Outcome help = run_mbcc({"run", model, "--help"});
  CHECK(help.exit_code == 0);
  CHECK(help.output.find("--repeat") != std::string::npos);
  CHECK(run_mbcc({"run", model, "--werror", "--quiet"}).exit_code == 0);
}

TEST_CASE("a model whose start is off runs if it is to be assembled, and by mass") {
  const Workshop shop;
  const Variable compiler("CXX", "/nonexistent/c++");
  const std::string model = shop.write("rod.mbd", R"(dimension 1
particle 1 { mass = 1; position = 0 }
particle 2 { mass = 3; position = 1.4 }
constraint rod : x2 - x1 = 1
integrate { to = 0; step = 1; method = rk4 }
)");
  CHECK(run_mbcc({"run", model}).exit_code == 1);
  const Run run = run_model(model, {"--assemble"});
  CHECK(run.exit_code == 0);
  CHECK(run.final_value("x1") == Approx(0.3).epsilon(1e-14));  // Newton's method ends within roundings
  CHECK(run.final_value("x2") == Approx(1.3).epsilon(1e-14));
}

TEST_CASE("a model's own code projects as the library does, where rows are redundant too") {
  const Workshop shop;
  const std::string model = R"(dimension 2
gravity (0, -9.81)
particle 1 { mass = 1; position = (0, 1); velocity = (1, 0) }
particle 2 { mass = 2; position = (2, 2.5); velocity = (1, 0) }
particle 3 { mass = 1; position = (5, 0); velocity = (1, 0) }
constraint crank  : x1^2 + y1^2 = 1
constraint rod    : (x2 - x1)^2 + (y2 - y1)^2 = 6.25
constraint rocker : (x2 - 2)^2 + y2^2 = 6.25
constraint again  : norm((x2 - 2, y2)) = 2.5
constraint skate  : vx3*sin(t) = vy3*cos(t)
)";
  const std::string own = shop.write("own.mbd", model + "integrate { to = 3; tolerance = 1e-7 }\n");
  const std::string other = shop.write("other.mbd", model + "integrate { to = 3; tolerance = 1e-7; step = 1 }\n");
  const Run by_model = run_model(own, {"--cxxflags=-O0"});
  const Run by_library = run_model(other, {"--cxxflags=-O0", "--method", "dop853"});
  REQUIRE(by_model.exit_code == 0);
  REQUIRE(by_library.exit_code == 0);
  CHECK(by_model.summary["projections"] == by_model.summary["steps"]);
  CHECK(by_model.summary["steps"] == by_library.summary["steps"]);
  for (const auto& [name, value] : by_library.summary["final"].items()) {
    // The same steps with other roundings, over a hundred of them.
    CHECK(by_model.final_value(name) == Approx(value.get<double>()).epsilon(1e-12).margin(1e-12));
  }
  CHECK(by_model.constraint_error("rod", "position") < 1e-13);
  CHECK(by_model.constraint_error("skate", "velocity") < 1e-13);
}

TEST_CASE("a compiler that fails is a bug in mbcc, and says what it said") {
  const Workshop shop;
  const std::string script = shop.write("broken-c++", "#!/bin/sh\necho out of order\nexit 1\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  const Variable compiler("CXX", script);
  const Outcome outcome = run_mbcc({"run", shop.write("pendulum.mbd", pendulum)});
  CHECK(outcome.exit_code == 70);
  CHECK(outcome.errors == "out of order\nmbcc: error: the emitted program did not build\n");
}

TEST_CASE("columns of many particles come in order of declaration, each with its own values") {
  const Workshop shop;
  const std::string model =
      shop.write("many.mbd",
                 "dimension 2\nfor i in 1..16 { particle p[i] { mass = 1; position = (i, 100 + i); velocity = (-i, 7*i)"
                 "; force = (i/4, i/8) } }\nintegrate { from = 0; to = 0; step = 1; method = rk4 }\n");
  std::string header = "t", row = "0";
  const auto add = [&](const std::string& name, double x, double y) {
    for (int i = 1; i <= 16; ++i) {
      header += fmt::format(",p[{0}].{1}x,p[{0}].{1}y", i, name);
      row += fmt::format(",{},{}", x * i, (name.empty() ? 100 : 0) + y * i);
    }
  };
  add("", 1, 1);
  add("v", -1, 7);
  add("a", 0.25, 0.125);
  for (const char* const compiler : {"c++", "/nonexistent/c++"}) {
    const Variable chosen("CXX", compiler);
    CHECK(run_mbcc({"run", model, "--quiet", "--cxxflags=-O0", "--csv", shop.path("rows.csv"), "--summary",
                    shop.path("summary.json")})
              .exit_code == 0);
    CHECK(shop.read("rows.csv") == header + "\n" + row + "\n");
    const std::string text = shop.read("summary.json");
    CHECK(text.find("\"p[1].x\": 1.0") < text.find("\"p[1].y\": 101.0"));
    CHECK(text.find("\"p[1].y\": 101.0") < text.find("\"p[2].x\": 2.0"));
    CHECK(text.find("\"p[2].x\": 2.0") < text.find("\"p[16].vy\": 112.0"));
  }
}

TEST_CASE("without a C++ compiler the interpreter gives the results of the compiled program, to the last digit") {
  // Both do the same operations in the same order; without contraction and at -O0 nothing merges or reorders them.
  const Workshop shop;
  for (const char* name : {"artigo5", "skate", "double_pendulum", "kepler", "closed_ring"}) {
    const std::string model = std::string(MBCC_SOURCE_DIR) + "/examples/" + name + "/" + name + ".mbd";
    const std::vector<std::string> flags = {"run", model, "--quiet", "--to", "0.5", "--csv"};
    std::vector<std::string> compiled = flags;
    compiled.insert(compiled.end(), {shop.path("compiled.csv"), "--cxxflags=-O0 -ffp-contract=off"});
    INFO(name);
    REQUIRE(run_mbcc(compiled).exit_code == 0);
    const Variable compiler("CXX", "/nonexistent/c++");
    std::vector<std::string> interpreted = flags;
    interpreted.push_back(shop.path("interpreted.csv"));
    const Outcome outcome = run_mbcc(interpreted);
    REQUIRE(outcome.exit_code == 0);
    CHECK(outcome.errors.find("mbcc: note: no C++ compiler found (`CXX`, `c++`): the interpreter runs the model\n") ==
          0);
    CHECK(shop.read("interpreted.csv").size() > 1000);
    CHECK(shop.read("interpreted.csv") == shop.read("compiled.csv"));
  }
}

}  // namespace mbcc::test
