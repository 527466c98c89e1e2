#include "scaling.hpp"

#include <fmt/core.h>

#include <map>

#include "emitted/emitted.hpp"

namespace bench {

namespace {

/// Parts side by side may cost a fifth more than each for itself: they share caches and registers.
constexpr double together = 1.2;

/// Long enough to be timed; what the step is does not matter to the cost.
constexpr double step = 0.001;
constexpr long steps = 200;

}  // namespace

std::vector<Growth> growth(Effort effort) {
  std::vector<std::string> models{"chain_10",      "chain_100",      "chain_10_twice", "artigo5",
                                  "artigo5_twice", "artigo5_beside", "bystanders"};
  std::vector<Subject> subjects;
  for (const std::string& model : models) {
    const auto program = emitted::find(model);
    if (!program) {
      return {};
    }
    subjects.push_back({{model, program->start, step, steps, {}, 0}, program->contender});
  }
  std::map<std::string, double> cost;
  const std::vector<Timing> timings = measure(subjects, effort);
  for (std::size_t k = 0; k < models.size(); ++k) {
    cost[models[k]] = timings[k].median;
  }
  return {
      {"100 links against 10 links", cost["chain_100"] / cost["chain_10"], 12},
      {"two chains of 10 links against twice one", cost["chain_10_twice"] / (2 * cost["chain_10"]), together},
      {"the paper's example twice against twice once", cost["artigo5_twice"] / (2 * cost["artigo5"]), together},
      {"the paper's example with ten particles at rest against the two apart",
       cost["artigo5_beside"] / (cost["artigo5"] + cost["bystanders"]), together},
  };
}

void print(const std::vector<Growth>& growths) {
  fmt::print("\nGrowth: cost of the emitted right-hand side, RK4 included, as a ratio\n\n");
  for (const Growth& growth : growths) {
    fmt::print("{:<70} {:>6.2f}   (at most {})\n", growth.what, growth.ratio, growth.limit);
  }
}

}  // namespace bench
