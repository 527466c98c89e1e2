#include "build_cost.hpp"

#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace bench {

namespace {

/// Processor seconds of all children that have ended.
double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

double cost_of(const std::string& command, int repeats) {
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repeats; ++i) {
    const double before = children_seconds();
    if (std::system(command.c_str()) != 0) {
      throw std::runtime_error("failed: " + command);
    }
    least = std::min(least, children_seconds() - before);
  }
  return least;
}

}  // namespace

BuildCost build_cost(const std::string& model, int repeats) {
  const std::string source = fmt::format("'{}/{}.mbd'", BENCH_MODELS, model);
  const std::string stem = fmt::format("{}/{}", BENCH_OUTPUT, model);
  BuildCost cost{model, 0, 0, 0, 0};
  cost.mbcc = cost_of(fmt::format("'{}' {} -o '{}.cpp'", BENCH_MBCC, source, stem), 5 * repeats);
  cost.cxx = cost_of(fmt::format("CCACHE_DISABLE=1 '{}' -std=c++20 -O2 '{}.cpp' -I'{}' '{}' -o '{}'", BENCH_CXX, stem,
                                 BENCH_RUNTIME_INCLUDE, BENCH_RUNTIME_LIBRARY, stem),
                     repeats);
  cost_of(fmt::format("'{}' {} --library -o '{}.hpp'", BENCH_MBCC, source, stem), 1);
  cost.program_size = std::filesystem::file_size(stem + ".cpp");
  cost.class_size = std::filesystem::file_size(stem + ".hpp");
  return cost;
}

void print(const std::vector<BuildCost>& costs) {
  fmt::print("\nFrom model to program: processor time of mbcc and of c++ -O2 (linked), sizes of the emitted files\n\n");
  fmt::print("{:<10} {:>10} {:>12} {:>14} {:>20}\n", "", "mbcc, ms", "c++ -O2, s", "program, byte",
             "class alone, byte");
  for (const BuildCost& cost : costs) {
    fmt::print("{:<10} {:>10.1f} {:>12.2f} {:>14} {:>20}\n", cost.model, 1e3 * cost.mbcc, cost.cxx, cost.program_size,
               cost.class_size);
  }
}

}  // namespace bench
