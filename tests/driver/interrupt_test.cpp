// Ctrl-C at every moment of `mbcc run`: exit code 130, nothing half-written, nothing said that nobody asked for.

#include "fixture.hpp"
#include "support/terminal.hpp"

namespace mbcc::test {
namespace {

constexpr const char* endless = R"(system endless
dimension 1
particle 1 { mass = 1; position = 0; velocity = 1 }
integrate { from = 0; to = 1e9; step = 0.001; method = rk4 }
)";

/// A compiler that says that it has begun, and then takes its time.
std::string slow_compiler(const Workshop& shop) {
  const std::string script =
      shop.write("slow-c++", "#!/bin/sh\necho begun >" + quoted(shop.path("begun")) + "\nexec sleep 60\n");
  std::filesystem::permissions(script, std::filesystem::perms::owner_all);
  return script;
}

void wait_for_file(const std::string& path) {
  while (!std::filesystem::exists(path)) {
    usleep(5000);
  }
}

}  // namespace

TEST_CASE("Ctrl-C while the program is built leaves nothing behind") {
  const Workshop shop;
  const Variable compiler("CXX", slow_compiler(shop));
  const std::string model = shop.write("endless.mbd", endless);
  for (const int signal : {SIGINT, SIGTERM}) {
    Terminal terminal(MBCC_BINARY, {"run", model});
    wait_for_file(shop.path("begun"));
    if (signal == SIGINT) {
      terminal.type(ctrl_c);
    } else {
      terminal.send(SIGTERM);  // to mbcc alone: it passes it on
    }
    CHECK(terminal.finish() == 130);
    CHECK(terminal.seen() == (signal == SIGINT ? "^C" : ""));
    std::filesystem::remove(shop.path("begun"));
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shop.path("cache"))) {
    CHECK(entry.is_directory());
  }
}

TEST_CASE("Ctrl-C while the model runs, built or interpreted, ends the run as the program would end it") {
  const Workshop shop;
  const std::string model = shop.write("endless.mbd", endless);
  const std::string figure = shop.path("figure.gp");
  struct Way {
    const char* compiler;
    std::vector<std::string> flags;
  };
  for (const Way& way : {Way{"c++", {}}, Way{"c++", {"--plot", figure, "--every", "1"}}, Way{"/nonexistent/c++", {}}}) {
    const Variable cxx("CXX", way.compiler);
    INFO(way.compiler << ' ' << way.flags.size());
    std::vector<std::string> arguments = {"run",        model,       "--cxxflags=-O0",
                                          "--progress", "--summary", shop.path("summary.json")};
    arguments.insert(arguments.end(), way.flags.begin(), way.flags.end());
    Terminal terminal(MBCC_BINARY, arguments);
    REQUIRE(terminal.wait_for("%, t = "));
    terminal.type(ctrl_c);
    CHECK(terminal.finish() == 130);
    CHECK(nlohmann::json::parse(shop.read("summary.json"))["status"] == "interrupted");
    CHECK(terminal.seen().find("endless: interrupted, rk4, ") != std::string::npos);
    CHECK(terminal.seen().find("error:") == std::string::npos);
  }
  CHECK(shop.has("figure.gp"));  // of what was recorded until then
}

}  // namespace mbcc::test
