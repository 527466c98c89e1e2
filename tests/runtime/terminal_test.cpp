// A run at a terminal: the bar, Ctrl-C, and what is left on the screen.

#include "support/terminal.hpp"

#include <catch2/catch.hpp>
#include <regex>

#include "sample_run.hpp"

using namespace mbrt::test;
using mbcc::test::ctrl_c;
using mbcc::test::Terminal;
using namespace std::chrono_literals;

namespace {

constexpr const char* erase_line = "\r\x1b[K";

/// A run that takes longer than anyone waits.
std::vector<std::string> endless(std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"throw", "--to", "1e9", "--step", "1e-3"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// What stands on the screen after the last time that a line was erased.
std::string left_on_screen(const std::string& seen) {
  return seen.substr(seen.rfind(erase_line) + std::string_view(erase_line).size());
}

}  // namespace

TEST_CASE("a run of more than a second shows a bar, and Ctrl-C ends it cleanly") {
  const mbcc::test::ScratchDirectory scratch;
  const auto begin = std::chrono::steady_clock::now();
  Terminal terminal(SAMPLES, endless({"--csv", scratch / "run.csv", "--every", "10", "--summary", scratch / "json"}),
                    100);
  Terminal silent(SAMPLES, endless({"--quiet"}));
  REQUIRE(terminal.wait_for(" remaining"));
  CHECK(std::chrono::steady_clock::now() - begin > 1s);
  terminal.type(ctrl_c);
  silent.type(ctrl_c);
  CHECK(terminal.finish() == 130);
  CHECK(silent.finish() == 130);
  CHECK(silent.seen() == "^C");

  INFO(terminal.seen());
  CHECK(std::regex_search(terminal.seen(), std::regex("\r\x1b\\[K\\[#*\\.*\\]   0 %, t = [^,]+, [0-9]+ (h|min) ")));
  CHECK(left_on_screen(terminal.seen()).rfind("throw: interrupted, rk4, ", 0) == 0);

  const auto summary = nlohmann::json::parse(mbcc::test::read_file(scratch / "json"));
  CHECK(summary["status"] == "interrupted");
  const std::string csv = mbcc::test::read_file(scratch / "run.csv");
  CHECK(csv.back() == '\n');
  CHECK(mbcc::test::parse_csv(csv).last("t") == summary["final"]["t"].get<double>());
}

TEST_CASE("a short run leaves the terminal alone") {
  Terminal terminal(SAMPLES, {"throw", "--to", "1", "--step", "0.1"});
  CHECK(terminal.finish() == 0);
  CHECK(terminal.seen().rfind("throw: ok, rk4, 10 steps of 0.1 from t = 0 to 1 in ", 0) == 0);
  CHECK(terminal.seen().find('\x1b') == std::string::npos);
}

TEST_CASE("the flag --progress shows the bar at once, as wide as the terminal allows") {
  Terminal wide(SAMPLES, {"throw", "--to", "1", "--step", "0.1", "--progress", "--quiet"}, 120);
  CHECK(wide.finish() == 0);
  CHECK(wide.seen() == std::string(erase_line) + "[" + std::string(40, '.') + "]   0 %, t = 0" + erase_line);
  Terminal narrow(SAMPLES, {"throw", "--to", "1", "--step", "0.1", "--progress", "--quiet"}, 20);
  CHECK(narrow.finish() == 0);
  CHECK(narrow.seen() == std::string(erase_line) + "  0 %, t = 0" + erase_line);
}

TEST_CASE("where nobody watches, --progress writes lines") {
  CHECK(run_plain("throw", {"--to", "1", "--step", "0.1", "--progress"}).errors == "100 %, t = 1\n");
  CHECK(run_plain("throw", {"--to", "0", "--step", "0.1", "--progress"}).errors == "100 %, t = 0\n");
  CHECK(run_plain("throw", {"--to", "1", "--step", "0.1"}).errors.empty());
}

TEST_CASE("rows in a pipe that nobody reads for a while are whole when the run is interrupted") {
  // The pipe fills and the run waits in the middle of a write; the signal comes there.
  const mbcc::test::Outcome outcome = mbcc::test::run_program(
      "/bin/sh", {"-c", std::string("(") + SAMPLES +
                            " throw --to 1e9 --step 1e-3 --csv - & sleep 0.3; kill $!; sleep 0.1; echo done >&2; "
                            "wait $!; echo $? >&2) | (sleep 0.6; tail -c 200)"});
  CHECK(outcome.errors == "done\n130\n");
  REQUIRE(!outcome.output.empty());
  CHECK(outcome.output.back() == '\n');
  const std::string last = outcome.output.substr(outcome.output.rfind('\n', outcome.output.size() - 2) + 1);
  CHECK(std::count(last.begin(), last.end(), ',') == 6);
}
