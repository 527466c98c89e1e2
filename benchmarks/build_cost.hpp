#pragma once
// What it costs to get from a model to a program.

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

/// Processor seconds, the least of several; sizes in bytes.
struct BuildCost {
  std::string model;
  double mbcc;  ///< mbcc MODEL.mbd -o MODEL.cpp
  double cxx;   ///< c++ -O2 MODEL.cpp, linked with the runtime
  std::uintmax_t program_size;
  std::uintmax_t class_size;  ///< with --library
};

/// Runs mbcc and the C++ compiler of this build on models of this build.
BuildCost build_cost(const std::string& model, int repeats);

void print(const std::vector<BuildCost>& costs);

}  // namespace bench
