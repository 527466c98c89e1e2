#pragma once
// A directory with models, a cache of its own, and the environment in which mbcc runs.

#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <string>

#include "support/run_model.hpp"
#include "support/variable.hpp"

namespace mbcc::test {

inline constexpr const char* pendulum = R"(system pendulum
dimension 2
parameter g = 9.81
particle bob { mass = 1; position = (1, 0) }
gravity (0, -g)
constraint rod : norm(bob.position) = 1
integrate { from = 0; to = 0.1; step = 0.01; method = rk4 }
)";
inline constexpr const char* wrong = "dimension 2\nparticle 1 { mass = 1; position = (1, 0) }\noutput r = x2\n";
inline constexpr const char* warned = "dimension 2\nparticle 1 { mass = 1; position = (1, 0) }\nlet r = x1\n";

struct Workshop {
  ScratchDirectory directory;
  Variable cache{"XDG_CACHE_HOME", directory / "cache"};

  std::string path(const std::string& name) const { return directory / name; }
  std::string write(const std::string& name, const std::string& text) const {
    write_file(directory / name, text);
    return path(name);
  }
  std::string read(const std::string& name) const { return read_file(directory / name); }
  bool has(const std::string& name) const { return std::filesystem::exists(directory / name); }
};

/// mbcc with `input` on standard input.
inline Outcome run_mbcc_on(const std::string& input, const std::string& arguments) {
  const ScratchDirectory scratch;
  write_file(scratch / "input", input);
  return run_program("/bin/sh", {"-c", quoted(MBCC_BINARY) + " " + arguments + " <" + quoted(scratch / "input")});
}

}  // namespace mbcc::test
