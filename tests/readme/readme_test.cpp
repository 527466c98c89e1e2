// The example of README.md is true: its model is the shipped one, its output is what mbcc prints, its code is what
// mbcc emits.
#include <catch2/catch.hpp>
#include <sstream>

#include "support/run_model.hpp"

namespace {

using namespace mbcc::test;

const std::filesystem::path root = MBCC_SOURCE_DIR;
const std::filesystem::path model = root / "examples/planar_pendulum/planar_pendulum.mbd";

/// The text of the n-th fenced block, from 0, that begins with "```" + language.
std::string block(const std::string& language, int n) {
  const std::string readme = read_file(root / "README.md");
  const std::string fence = "```" + language + "\n";
  std::size_t at = 0;
  for (;; --n) {
    at = readme.find(fence, at);
    REQUIRE(at != std::string::npos);
    const std::size_t end = readme.find("\n```", at + fence.size());
    REQUIRE(end != std::string::npos);
    if (n == 0) {
      return readme.substr(at + fence.size(), end + 1 - at - fence.size());
    }
    at = end + 4;
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

}  // namespace

TEST_CASE("the model in the README is the shipped example") {
  CHECK(read_file(model).find(block("", 0)) != std::string::npos);
}

TEST_CASE("mbcc prints what the README shows") {
  const Outcome outcome = run_mbcc({"run", model.string()});
  REQUIRE(outcome.exit_code == 0);
  const std::vector<std::string> shown = lines_of(block("", 1));
  const std::vector<std::string> printed = lines_of(outcome.output);
  REQUIRE(shown.size() == printed.size());
  REQUIRE(shown.size() == 4);

  const auto without_time = [](const std::string& line) { return line.substr(0, line.rfind(" in ")); };
  CHECK(without_time(printed[0]) == without_time(shown[0]));
  CHECK(printed[1] == shown[1]);
  CHECK(printed[3] == shown[3]);

  // The errors of the method agree; those of rounding differ between machines, the last column among them.
  std::string name;
  double position = 0, velocity = 0;
  std::istringstream(printed[2]) >> name >> position >> velocity;
  std::string shown_name;
  double shown_position = 0, shown_velocity = 0;
  std::istringstream(shown[2]) >> shown_name >> shown_position >> shown_velocity;
  CHECK(name == shown_name);
  CHECK(position == Approx(shown_position).epsilon(1e-5));
  CHECK(velocity == Approx(shown_velocity).epsilon(1e-5));
}

TEST_CASE("mbcc emits the code that the README shows") {
  const Outcome outcome = run_mbcc({model.string(), "-o", "-"});
  REQUIRE(outcome.exit_code == 0);
  CHECK(outcome.output.find(block("cpp", 0)) != std::string::npos);
}
