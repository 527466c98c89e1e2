#pragma once
// Kernels of a Program as the bodies of C++ functions.

#include <string>
#include <unordered_map>
#include <vector>

#include "emit/code.hpp"
#include "emit/names.hpp"
#include "model/system.hpp"
#include "program/program.hpp"

namespace mbcc::cpp {

/// The identifiers that all kernels of a class share: leaves and members.
struct Naming {
  Scope scope;  ///< with all of them declared; each kernel goes on with a copy
  std::vector<std::string> coordinates, speeds, accelerations, parameters;
  std::unordered_map<program::NodeId, std::string> members;  ///< values kept between kernels
  bool keeps_time = false;                                   ///< whether a kernel reads t itself
};

Naming make_naming(const model::System& system, const program::Program& program);

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

Body write_kernel(const program::Kernel& kernel, const program::Program& program, const Naming& naming,
                  std::size_t coordinates, const Comments& comments);

}  // namespace mbcc::cpp
