// docs/tutorial.md as its reader lives through it: an mbcc is installed, every file of the page is written, every
// command run in order, and what it prints is what stands there.

#include <catch2/catch.hpp>

#include "support/markdown.hpp"

namespace mbcc::test {
namespace {

/// A shell whose user has installed mbcc, in a directory of its own.
class Reader {
 public:
  Reader() {
    REQUIRE(run_program(CMAKE_PROGRAM, {"--install", MBCC_BUILD, "--prefix", home_ / "installed"}).exit_code == 0);
    std::filesystem::create_directory(home_ / "work");
    std::filesystem::create_directory(home_ / "tools");
    // The compiler of this build, with its flags: a runtime with sanitizers links with them alone.
    write_file(home_ / "tools/c++", std::string("#!/bin/sh\nexec " MBCC_CXX " " MBCC_CXX_FLAGS " \"$@\"\n"));
    std::filesystem::permissions(home_ / "tools/c++", std::filesystem::perms::owner_all);
  }

  void write(const Block& file) const { write_file(home_ / ("work/" + file.name), file.text); }

  std::vector<std::string> run(const std::string& command) const {
    const std::string home = home_ / "";
    const std::string setting =
        "cd " + quoted(home + "work") + "; export LC_ALL=C PATH=" + quoted(home + "tools:" + home + "installed/bin:") +
        "\"$PATH\"" + " PKG_CONFIG_PATH=" + quoted(home + "installed/" MBCC_LIBDIR "/pkgconfig") +
        " CMAKE_PREFIX_PATH=" + quoted(home + "installed") + " XDG_CACHE_HOME=" + quoted(home + "cache") +
        "; unset CXX CXXFLAGS; exec 2>&1; ";
    const Outcome outcome = run_program("/bin/sh", {"-c", setting + command});
    CHECK(outcome.exit_code == 0);
    return lines_of(outcome.output);
  }

 private:
  ScratchDirectory home_;
};

bool is_number(const std::string& word, double& value) {
  char* end = nullptr;
  value = std::strtod(word.c_str(), &end);
  return !word.empty() && end == word.c_str() + word.size();
}

/// Numbers may differ by what compilers do otherwise: the rounding of 1e-12 in the errors of thousands of steps.
bool same_word(const std::string& found, const std::string& shown) {
  double a = 0, b = 0;
  if (is_number(found, a) && is_number(shown, b)) {
    return std::abs(a - b) <= std::max(1e-12, 1e-5 * std::abs(b));
  }
  return found == shown;
}

/// Word by word and cell by cell, but for the time that a run took.
bool same_line(std::string found, std::string shown) {
  for (std::string* line : {&found, &shown}) {
    if (line->find(" steps of ") != std::string::npos) {
      line->erase(line->rfind(" in "));
    }
    std::replace(line->begin(), line->end(), ',', ' ');
  }
  std::istringstream found_words(found), shown_words(shown);
  std::string a, b;
  while (found_words >> a) {
    if (!(shown_words >> b) || !same_word(a, b)) {
      return false;
    }
  }
  return !(shown_words >> b);
}

/// Line by line; a line "..." stands for any number of them.
bool matches(const std::vector<std::string>& found, std::size_t i, const std::vector<std::string>& shown,
             std::size_t j) {
  if (j == shown.size()) {
    return i == found.size();
  }
  if (shown[j] == "...") {
    return matches(found, i, shown, j + 1) || (i < found.size() && matches(found, i + 1, shown, j));
  }
  return i < found.size() && same_line(found[i], shown[j]) && matches(found, i + 1, shown, j + 1);
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

}  // namespace

TEST_CASE("the tutorial's commands do what it says") {
  const Reader reader;
  int commands = 0;
  for (const Block& block : blocks_of(std::filesystem::path(MBCC_SOURCE_DIR) / "docs/tutorial.md")) {
    if (block.language != "console") {
      reader.write(block);
      continue;
    }
    const std::vector<std::string> lines = lines_of(block.text);
    for (std::size_t i = 0; i < lines.size();) {
      REQUIRE(lines[i].rfind("$ ", 0) == 0);
      const std::string command = lines[i].substr(2);
      const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(++i);
      while (i < lines.size() && lines[i].rfind("$ ", 0) != 0) {
        ++i;
      }
      const std::vector<std::string> shown(begin, lines.begin() + static_cast<std::ptrdiff_t>(i));
      const std::vector<std::string> found = reader.run(command);
      INFO("$ " << command << '\n' << joined(found) << "shown:\n" << joined(shown));
      CHECK(matches(found, 0, shown, 0));
      ++commands;
    }
  }
  CHECK(commands > 15);
}

}  // namespace mbcc::test
