#pragma once
// Results as texts.

#include <catch2/catch.hpp>
#include <string>

#include "diagnostics/render.hpp"
#include "figure/table.hpp"

namespace mbcc::test {

/// The table in `text`, which must be one.
inline figure::Table table_of(const std::string& text, const std::string& name = "result.csv") {
  Sources sources;
  Diagnostics diagnostics;
  auto table = figure::read_table(sources, sources.add(name, text), diagnostics);
  INFO(render(diagnostics, sources));
  REQUIRE(table);
  return *table;
}

/// What is said of a `text` that is no table.
inline std::string complaint_about(const std::string& text) {
  Sources sources;
  Diagnostics diagnostics;
  CHECK_FALSE(figure::read_table(sources, sources.add("result.csv", text), diagnostics));
  return render(diagnostics, sources);
}

}  // namespace mbcc::test
