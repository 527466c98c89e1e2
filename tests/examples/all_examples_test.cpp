// What holds for every example, whatever its physics: it has a page, mbcc finds no fault in it, and it runs as it
// stands.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> found;
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(MBCC_SOURCE_DIR) / "examples")) {
    if (entry.is_directory()) {
      found.push_back(entry.path().filename().string());
    }
  }
  return found;
}

}  // namespace

TEST_CASE("every example has a model and a page that tells how to run it") {
  for (const std::string& name : names()) {
    INFO(name);
    CHECK(std::filesystem::exists(example(name)));
    const std::string page = read_file(example(name).parent_path() / "README.md");
    CHECK(page.find("mbcc run examples/" + name + "/" + name + ".mbd") != std::string::npos);
  }
}

TEST_CASE("mbcc warns of redundant constraints in the examples, and of nothing else") {
  for (const std::string& name : names()) {
    const Outcome check = run_mbcc({"check", example(name).string()});
    INFO(name << '\n' << check.errors);
    CHECK(check.exit_code == 0);
    const bool redundant = name == "ring_and_disc";  // one of its four conditions follows from the others
    CHECK((check.errors.find("warning") != std::string::npos) == redundant);
  }
}

}  // namespace mbcc::test
