#pragma once
// Kernels of a Program as the bodies of C++ functions.

#include <string>
#include <vector>

#include "emit/naming.hpp"
#include "program/program.hpp"

namespace mbcc::cpp {

/// Comments before the parts of a kernel: lines without `//`, empty for none.
struct Comments {
  std::vector<std::string> sections;  ///< one per section, or fewer
  std::vector<std::string> islands;   ///< one per island
};

/// A function body, and which of the function's arguments it reads.
struct Body {
  std::string text;
  bool reads_state = false;
  bool reads_rate = false;
};

/// Straight-line code, and loops for what repeats itself (program/roll.hpp).
Body write_kernel(const program::Kernel& kernel, const program::Program& program, const Naming& naming,
                  const Comments& comments);

/// A kernel that opens a function: what it provides is local, and has the names of `within` in the rest of the
/// function.
struct Opening {
  Body body;
  Naming within;
};
Opening write_opening(const program::Kernel& kernel, const program::Program& program, const Naming& naming);

}  // namespace mbcc::cpp
