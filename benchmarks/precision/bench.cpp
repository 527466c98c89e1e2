// mbcc_bench_precision: run time against true error of emitted code by every method, beside code by hand and beside the
// generic way, from one run. One line for each point: problem, contender, setting, seconds, error, separated by tabs.
//   mbcc_bench_precision [--short] [PROBLEM...]   --short: few samples, and no scene that takes long
//   mbcc_bench_precision --scenes DIRECTORY       writes the scenes that other programs make their models from
// Exit codes: 0 measured, 1 emitted code came nowhere near a reference, 2 wrong usage.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <map>

#include "precision/by_hand.hpp"
#include "precision/hung_chain.hpp"
#include "precision/measure.hpp"
#include "precision/pinv.hpp"
#include "precision/program.hpp"

namespace bench::precision {

namespace {

/// What mbcc's methods of order 8 and more reach in every problem, whose motions raise rounding to 1e-9 at most.
constexpr double near = 1e-7;

std::vector<Contender> contenders_of(const Problem& problem) {
  const Program program = program_of(problem.model).value();
  std::vector<Contender> all = program.contenders(problem);
  for (std::vector<Contender> more : {by_hand(problem, program.start), by_pinv(problem, program.start)}) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  }
  return all;
}

/// Whether emitted code with steps of its own choice came near the reference.
bool show(const Problem& problem, Effort effort) {
  std::map<std::string, double> best;
  for (const Point& point : measure(contenders_of(problem), problem, effort)) {
    fmt::print("{}\t{}\t{:.3g}\t{:.4g}\t{:.3g}\n", problem.name, point.contender, point.setting, point.seconds,
               point.error);
    if (point.setting < 1 && point.contender.rfind("mbcc", 0) == 0) {
      const auto [at, is_first] = best.try_emplace(point.contender, point.error);
      at->second = std::fmin(at->second, point.error);
    }
  }
  bool is_well = true;
  for (const auto& [contender, error] : best) {
    if (!(error < near)) {
      fmt::print(stderr, "{}: {} stays {:.1e} away from the reference\n", problem.name, contender, error);
      is_well = false;
    }
  }
  return is_well;
}

void write_scenes(const std::string& directory) {
  for (const Problem& problem : problems()) {
    if (const std::optional<HungChain> chain = hung_chain(problem, program_of(problem.model).value().start)) {
      std::ofstream file(directory + "/" + problem.name + ".txt");
      file << to_text(*chain);
      file.close();
      if (!file) {
        throw std::runtime_error("cannot write into " + directory);
      }
    }
  }
}

int run(std::vector<std::string> words) {
  if (words.size() == 2 && words[0] == "--scenes") {
    write_scenes(words[1]);
    return 0;
  }
  const bool is_short = !words.empty() && words[0] == "--short";
  words.erase(words.begin(), words.begin() + (is_short ? 1 : 0));
  const std::vector<Problem> all = problems();
  const auto is_problem = [&](const std::string& word) {
    return std::any_of(all.begin(), all.end(), [&](const Problem& problem) { return problem.name == word; });
  };
  if (!std::all_of(words.begin(), words.end(), is_problem)) {
    fmt::print(stderr, "usage: mbcc_bench_precision [--short] [PROBLEM...] | --scenes DIRECTORY\n");
    return 2;
  }
  bool is_well = true;
  for (const Problem& problem : all) {
    if (words.empty() || std::find(words.begin(), words.end(), problem.name) != words.end()) {
      is_well &= show(problem, is_short ? Effort{1, 0.01} : Effort{15, 0.2});
    }
  }
  return is_well ? 0 : 1;
}

}  // namespace

}  // namespace bench::precision

int main(int argc, char** argv) {
  try {
    return bench::precision::run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& failure) {
    fmt::print(stderr, "mbcc_bench_precision: {}\n", failure.what());
    return 1;
  }
}
