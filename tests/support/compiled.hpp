#pragma once
// Model text through the passes of the compiler, for tests of what comes out of them.

#include <catch2/catch.hpp>
#include <string>

#include "diagnostics/render.hpp"
#include "driver/compile.hpp"
#include "mechanics/point.hpp"

namespace mbcc::test {

inline std::string messages_of(const Compilation& compilation) {
  return render(compilation.diagnostics, compilation.sources);
}

/// Of a model in which nothing is wrong; warnings are allowed.
inline Compilation compiled(const std::string& text, Stage until = Stage::Program) {
  Compilation compilation = compile("model.mbd", text, {false, until});
  INFO(text);
  INFO(messages_of(compilation));
  REQUIRE_FALSE(compilation.diagnostics.has_errors());
  return compilation;
}

/// Coordinates, then speeds, at the start of a run.
inline std::vector<double> start_state(const Compilation& compilation) {
  const mechanics::Point start = mechanics::initial_point(*compilation.system, compilation.equations);
  std::vector<double> state = start.coordinates;
  state.insert(state.end(), start.speeds.begin(), start.speeds.end());
  return state;
}

}  // namespace mbcc::test
