// What compiling writes, and what it leaves alone.

#include "fixture.hpp"

namespace mbcc::test {

TEST_CASE("standard input and standard output can stand for files") {
  const Workshop shop;
  const std::string model = shop.write("model.mbd", pendulum);
  REQUIRE(run_mbcc({model, "-o", shop.path("sim.cpp")}).exit_code == 0);
  CHECK(run_mbcc({model, "-o", "-"}).output == shop.read("sim.cpp"));
  CHECK(run_mbcc_on(pendulum, "- -o -").output == shop.read("sim.cpp"));
  CHECK(run_mbcc_on(pendulum, "check -").exit_code == 0);
}

TEST_CASE("a failed compilation leaves the old file as it was, and nothing beside it") {
  const Workshop shop;
  const std::string output = shop.write("sim.cpp", "old");
  CHECK(run_mbcc({shop.write("wrong.mbd", wrong), "-o", output}).exit_code == 1);
  CHECK(run_mbcc({shop.write("warned.mbd", warned), "-o", output, "--werror"}).exit_code == 1);
  CHECK(run_mbcc({shop.path("none.mbd"), "-o", output}).exit_code == 2);
  CHECK(shop.read("sim.cpp") == "old");
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shop.directory / ".")) {
    files += entry.is_regular_file() ? std::size_t{1} : std::size_t{0};
  }
  CHECK(files == 3);
}

TEST_CASE("an output that cannot be replaced stays, and is exit code 2") {
  const Workshop shop;
  const std::string model = shop.write("model.mbd", pendulum);
  std::filesystem::create_directories(shop.directory / "folder.cpp/inside");
  const Outcome outcome = run_mbcc({model, "-o", shop.path("folder.cpp")});
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors == "mbcc: error: cannot write `" + shop.path("folder.cpp") + "`\n");
  CHECK(shop.has("folder.cpp/inside"));
  CHECK(run_mbcc({model, "-o", "/dev/full"}).exit_code == 2);
}

TEST_CASE("a depfile names every file that was read") {
  const Workshop shop;
  shop.write("part.mbd", "parameter g = 9.81\n");
  const std::string model = shop.write(
      "my model.mbd", "dimension 1\nimport \"part.mbd\"\nparticle 1 { mass = 1; position = 0; force = g }\n");
  REQUIRE(run_mbcc({model, "-o", shop.path("sim.cpp"), "--depfile", shop.path("sim.d")}).exit_code == 0);
  const std::string folder = shop.path("");
  CHECK(shop.read("sim.d") == folder + "sim.cpp: " + folder + "my\\ model.mbd " + folder + "part.mbd\n");
}

TEST_CASE("the flag --library emits the class alone") {
  const Workshop shop;
  const Outcome outcome = run_mbcc({shop.write("pendulum.mbd", pendulum), "--library", "-o", "-"});
  CHECK(outcome.output.find("namespace pendulum {") != std::string::npos);
  for (const char* absent : {"int main", "iostream", "simulation.hpp", "new ", "std::vector", "Eigen"}) {
    INFO(absent);
    CHECK(outcome.output.find(absent) == std::string::npos);
  }
}

TEST_CASE("verify accepts what mbcc emits, with the options that it was emitted with") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  for (const std::vector<std::string>& options : std::vector<std::vector<std::string>>{{}, {"--library"}}) {
    std::vector<std::string> arguments = {model, "-o", shop.path("sim.cpp")};
    arguments.insert(arguments.end(), options.begin(), options.end());
    REQUIRE(run_mbcc(arguments).exit_code == 0);
    const Outcome outcome = run_mbcc({"verify", model, shop.path("sim.cpp")});
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.output.empty());
  }
}

TEST_CASE("verify shows where a file differs from what mbcc emits") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  REQUIRE(run_mbcc({model, "-o", shop.path("sim.cpp")}).exit_code == 0);
  std::string changed = shop.read("sim.cpp");
  changed.replace(changed.find("9.81"), 4, "1.62");
  const Outcome outcome = run_mbcc({"verify", model, shop.write("changed.cpp", changed + "// more\n")});
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.errors.empty());
  const std::string version = run_mbcc({"--version"}).output;
  CHECK(outcome.output.find("--- " + shop.path("changed.cpp") + "\n+++ what " + version.substr(0, version.find('\n')) +
                            " emits for " + model + "\n@@ -") == 0);
  CHECK(outcome.output.find("\n-        {\"g\", 1.62},\n+        {\"g\", 9.81},\n") != std::string::npos);
  CHECK(outcome.output.find("\n }\n-// more\n") != std::string::npos);
  CHECK(std::count(outcome.output.begin(), outcome.output.end(), '\n') <
        30);  // two hunks, and not what is between them
  const Variable path("PATH", "/nonexistent");
  const Outcome untold = run_mbcc({"verify", model, shop.path("changed.cpp")});
  CHECK(untold.exit_code == 1);
  CHECK(untold.errors == "mbcc: error: `" + shop.path("changed.cpp") + "` is not what " +
                             version.substr(0, version.find('\n')) + " emits for " + model +
                             ", and `diff` could not show where\n");
}

TEST_CASE("verify refuses a file that mbcc did not emit") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const Outcome foreign = run_mbcc({"verify", model, model});
  CHECK(foreign.exit_code == 1);
  CHECK(foreign.errors == "mbcc: error: `" + model + "` is no file that mbcc emitted: its header names no options\n");
}

TEST_CASE("every stage can be dumped") {
  const Workshop shop;
  const std::string model = shop.write("pendulum.mbd", pendulum);
  const std::vector<std::pair<std::string, std::string>> stages = {{"tokens", "pendulum"},
                                                                   {"syntax", "constraint"},
                                                                   {"system", "bob.x"},
                                                                   {"equations", "rod (holonomic) = "},
                                                                   {"derivatives", "A[rod, bob.ax] = "},
                                                                   {"program", "kernel rates\n"}};
  for (const auto& [stage, expected] : stages) {
    const Outcome outcome = run_mbcc({"dump", model, "--stage=" + stage});
    INFO(stage);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.output.find(expected) != std::string::npos);
  }
  CHECK(run_mbcc({"dump", model, "--stage=derivatives", "--partials"}).output ==
        "rod: t-flag false, v-flag false\n"
        "  value 0\n"
        "  d/dbob.x 1\n"
        "  d/dbob.y 0\n"
        "  d2/dbob.x dbob.x 0\n"
        "  d2/dbob.x dbob.y 0\n"
        "  d2/dbob.y dbob.y 1\n");
}

TEST_CASE("check shows the structure of the paper's example") {
  const Outcome outcome = run_mbcc({"check", std::string(MBCC_SOURCE_DIR) + "/examples/artigo5/artigo5.mbd"});
  CHECK(outcome.output.substr(0, outcome.output.find("operations\n")) ==
        "artigo5: 6 coordinates, 6 speeds, 2 degrees of freedom\n"
        "4 constraints: 2 holonomic, 2 nonholonomic; rank 4 at the start\n"
        "island 1: 3 speeds, 2 constraints, rank 2\n"
        "  sphere [artigo5.mbd:18] (holonomic) joins vx1 vy1 vz1\n"
        "  meridian [artigo5.mbd:19] (holonomic) joins vx1 vy1\n"
        "island 2: 2 speeds, 2 constraints, rank 2\n"
        "  constraint_3 [artigo5.mbd:20] (nonholonomic) joins vx2 vy2\n"
        "  constraint_4 [artigo5.mbd:21] (nonholonomic) joins vx2 vy2\n"
        "without constraints: vz2\n");
  for (const char* line : {"\n  per state: ", "\n  per time: ", "\n  per run: "}) {
    CHECK(outcome.output.find(line) != std::string::npos);
  }
}

}  // namespace mbcc::test
