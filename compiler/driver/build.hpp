#pragma once
// Building emitted programs for `mbcc run`, once per content.

#include <optional>
#include <string>
#include <vector>

namespace mbcc {

/// The C++ compiler as a command: `CXX`, or `c++`; nothing if there is no such program.
std::optional<std::vector<std::string>> find_cxx_compiler();

/// What `mbcc run` compiles with unless it is told otherwise.
inline constexpr const char* default_cxx_flags = "-O3 -march=native";

struct BuildResult {
  std::string program;  ///< path of the executable; empty if the build failed
  std::string output;   ///< what the compiler said, or why the build could not start
  bool interrupted;     ///< the build failed because mbcc was asked to stop
};

/// Compiles and links `source`. The program is kept in the user's cache directory ($XDG_CACHE_HOME/mbcc or
/// ~/.cache/mbcc, else one below the directory for temporary files) and found there again when source, compiler,
/// flags and runtime are the same.
BuildResult build_program(const std::string& source, const std::vector<std::string>& compiler,
                          const std::vector<std::string>& flags);

/// Words of a command line, split at spaces.
std::vector<std::string> split_words(const std::string& text);

}  // namespace mbcc
