// Every message of name resolution, whole: bad/*.mbd and what mbcc says about them, in bad/transcript.txt.
// After a wanted change of wording, MBCC_ACCEPT=1 in the environment writes the transcript anew.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "resolved.hpp"

namespace mbcc {
namespace {

using test::Files;
using test::Resolved;

const std::filesystem::path folder = std::filesystem::path(MBCC_SOURCE_DIR) / "tests/model/bad";

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Files bad_models() {
  Files files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".mbd") {
      files[entry.path().lexically_relative(folder).string()] = read(entry.path());
    }
  }
  return files;
}

/// Definitions in an order in which each waits for the next.
std::string deep_model() {
  std::string text = "dimension 1\nparticle 1 { mass = 1; position = a0 }\n";
  for (int i = 0; i < 2000; ++i) {
    text += "let a" + std::to_string(i) + " = a" + std::to_string(i + 1) + "\n";
  }
  return text + "let a2000 = 1\n";
}

std::vector<std::pair<std::string, Resolved>> all_bad() {
  std::vector<std::pair<std::string, Resolved>> all;
  const Files files = bad_models();
  for (const auto& file : files) {
    if (file.first.find('/') == std::string::npos) {  // those in folders are imported
      all.emplace_back(file.first, test::resolve_files(files, file.first));
    }
  }
  all.emplace_back("a very deep model", test::resolve_text(deep_model()));
  return all;
}

TEST_CASE("messages are those of the transcript") {
  std::string transcript;
  for (const auto& [name, resolved] : all_bad()) {
    transcript += "== " + name + "\n" + resolved.messages();
  }
  if (std::getenv("MBCC_ACCEPT") != nullptr) {
    std::ofstream(folder / "transcript.txt") << transcript;
  }
  CHECK(transcript == read(folder / "transcript.txt"));
}

TEST_CASE("every finding of this layer is in the transcript") {
  std::set<Finding> seen;
  for (const auto& [name, resolved] : all_bad()) {
    for (const Diagnostic& diagnostic : resolved.diagnostics.all()) {
      seen.insert(diagnostic.finding);
    }
  }
  for (int row = static_cast<int>(Finding::UnknownName); row <= static_cast<int>(Finding::EmptyLoop); ++row) {
    const auto finding = static_cast<Finding>(row);
    INFO(name_of(finding));
    CHECK(seen.count(finding) == 1);
  }
}

TEST_CASE("there is a System if and only if there is no error") {
  for (const auto& [name, resolved] : all_bad()) {
    INFO(name);
    CHECK(resolved.system.has_value() == !resolved.diagnostics.has_errors());
  }
}

}  // namespace
}  // namespace mbcc
