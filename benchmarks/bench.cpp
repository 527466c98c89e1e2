// mbcc_bench: emitted code beside an expert's and the generic way, from one run. `--short` for a quick look.
// Exit codes: 0 measured, 1 contenders disagree or a command failed, 2 wrong usage.

#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <string_view>

#include "build_cost.hpp"
#include "comparison.hpp"
#include "scaling.hpp"

namespace bench {

namespace {

struct Plan {
  Effort effort;
  std::vector<Scene> scenes;
  int build_repeats;
};

/// Samples are short, so that many fit between two interruptions, but hold at least thousands of evaluations.
Plan plan(bool brief) {
  if (brief) {
    return {{9, 0.002}, {paper_example(), chain(3), chain(10), chain(100)}, 1};
  }
  return {{41, 0.005}, {paper_example(), chain(3), chain(10), chain(100), chain(200)}, 3};
}

bool run(const Plan& plan) {
  std::vector<Comparison> comparisons;
  bool agree = true;
  for (const Scene& scene : plan.scenes) {
    comparisons.push_back(compare(scene, plan.effort));
    agree = agree && comparisons.back().agrees();
  }
  print(comparisons);
  const std::vector<Growth> growths = growth(plan.effort);
  if (growths.empty()) {
    fmt::print("\nThis build has no mbcc: nothing emitted was measured.\n");
  } else {
    print(growths);
    std::vector<BuildCost> costs;
    for (const Scene& scene : plan.scenes) {
      costs.push_back(build_cost(scene.model, plan.build_repeats));
    }
    print(costs);
  }
  if (!agree) {
    fmt::print(stderr, "\nthe contenders did not compute the same motion: their times cannot be compared\n");
  }
  return agree;
}

}  // namespace

}  // namespace bench

int main(int argc, char** argv) {
  const bool brief = argc == 2 && std::string_view(argv[1]) == "--short";
  if (argc > 1 && !brief) {
    fmt::print(stderr, "usage: mbcc_bench [--short]\n");
    return 2;
  }
  try {
    return bench::run(bench::plan(brief)) ? 0 : 1;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "mbcc_bench: {}\n", failure.what());
    return 1;
  }
}
