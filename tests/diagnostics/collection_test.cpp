// The message table and the collection of findings.

#include <catch2/catch.hpp>
#include <regex>

#include "diagnostics/diagnostic.hpp"

namespace mbcc {
namespace {

const std::vector<Finding> findings = {
#define MBCC_DIAGNOSTIC(name, severity, text) Finding::name,
#include "diagnostics/diagnostics.def"
#undef MBCC_DIAGNOSTIC
};

}  // namespace

TEST_CASE("findings are collected in order, with severity, text and notes") {
  Diagnostics diagnostics;
  diagnostics.report(Finding::Expected, {0, 1, 2}, "a name", "`)`").note({0, 0, 1}, "`(` opens here");
  diagnostics.report(Finding::PowerOfPower, {0, 3, 4}, "a^b^c", "(a^b)^c");
  REQUIRE(diagnostics.all().size() == 2);
  CHECK(diagnostics.errors() == 1);
  CHECK(diagnostics.warnings() == 1);
  CHECK(diagnostics.has_errors());
  const Diagnostic& first = diagnostics.all()[0];
  CHECK(first.severity == Severity::Error);
  CHECK(first.span == Span{0, 1, 2});
  CHECK(first.message == "expected a name, found `)`");
  REQUIRE(first.notes.size() == 1);
  CHECK(first.notes[0].message == "`(` opens here");
  CHECK(diagnostics.all()[1].severity == Severity::Warning);
  CHECK_FALSE(Diagnostics().has_errors());
}

TEST_CASE("a row of the table has its name, its severity and its text") {
  CHECK(name_of(Finding::UnmatchedBrace) == "UnmatchedBrace");
  CHECK(severity_of(Finding::UnmatchedBrace) == Severity::Error);
  CHECK(text_of(Finding::UnmatchedBrace) == "`}}` closes nothing");
}

TEST_CASE("all messages speak with one voice") {
  for (const Finding finding : findings) {
    const std::string text(text_of(finding));
    INFO(name_of(finding) << ": " << text);
    CHECK(std::regex_search(text, std::regex("^([a-z]|`|\\{)")));  // lower case
    CHECK_FALSE(std::regex_search(text, std::regex("[.!]$")));     // no full stop
    CHECK(std::count(text.begin(), text.end(), '`') % 2 == 0);     // code between two backticks
    CHECK_FALSE(std::regex_search(text, std::regex("\\b(please|invalid|illegal|oops)\\b")));
  }
}

}  // namespace mbcc
