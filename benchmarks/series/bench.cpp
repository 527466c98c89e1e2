// mbcc_bench_series: run time against true error of the emitted Taylor series, beside dop853 on the same emitted model
// and beside a Taylor integrator written by hand for chains, from one run.
// Exit codes: 0 measured, 1 no contender came near a reference.

#include <fmt/core.h>
#include <time.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "series/contender.hpp"
#include "series/problems.hpp"

namespace bench::series {

namespace {

struct Point {
  double error;
  double milliseconds;
};

/// Milliseconds of processor time that this thread has had.
double thread_milliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double error_of(const std::vector<double>& end, std::span<const double> reference) {
  double largest = 0;
  for (std::size_t j = 0; j < reference.size(); ++j) {
    largest = std::max(largest, std::abs(end[j] - reference[j]));
  }
  return largest;
}

/// All contenders at all tolerances, in turn and again and again, so that what slows the machine slows all of them;
/// the least time of each. Points of one contender by falling error; what costs more without being better is left out.
std::vector<std::vector<Point>> measure(const std::vector<Contender>& contenders, const Problem& problem) {
  constexpr int samples = 15;
  constexpr int lowest_decade = 15;
  std::vector<std::vector<Point>> points(contenders.size());
  for (int sample = 0; sample < samples; ++sample) {
    for (std::size_t c = 0; c < contenders.size(); ++c) {
      for (int half_decade = 6; half_decade <= 2 * lowest_decade; ++half_decade) {
        const double tolerance = std::pow(10, -0.5 * half_decade);
        const double begin = thread_milliseconds();
        const std::vector<double> end = contenders[c].integrate(tolerance);
        const double taken = thread_milliseconds() - begin;
        const std::size_t at = static_cast<std::size_t>(half_decade) - 6;
        if (points[c].size() <= at) {
          points[c].push_back({error_of(end, problem.end), taken});
        }
        points[c][at].milliseconds = std::min(points[c][at].milliseconds, taken);
      }
    }
  }
  for (std::vector<Point>& of_one : points) {
    std::erase_if(of_one, [all = of_one](const Point& point) {
      return std::any_of(all.begin(), all.end(), [&](const Point& other) {
        return other.milliseconds < point.milliseconds && other.error <= point.error;
      });
    });
    std::sort(of_one.begin(), of_one.end(), [](const Point& a, const Point& b) { return a.error > b.error; });
  }
  return points;
}

/// The time at which a contender reaches an error, between measured points along a line in logarithms.
std::optional<double> time_at(const std::vector<Point>& points, double error) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].error > error) {
      continue;
    }
    if (i == 0) {
      return std::nullopt;  // better at once: what the error costs is not known
    }
    const double part = std::log(points[i - 1].error / error) / std::log(points[i - 1].error / points[i].error);
    return points[i - 1].milliseconds * std::pow(points[i].milliseconds / points[i - 1].milliseconds, part);
  }
  return std::nullopt;
}

/// Whether the first contender, the emitted series, has come near the reference.
bool show(const Problem& problem) {
  std::vector<Contender> contenders = emitted(problem.model);
  if (contenders.empty()) {
    fmt::print("This build has no mbcc: nothing emitted was measured.\n");
    return true;
  }
  if (const std::optional<Contender> hand = by_hand(problem.model, problem.to)) {
    contenders.push_back(*hand);
  }
  const std::vector<std::vector<Point>> points = measure(contenders, problem);
  fmt::print("\n{}\n{:8}", problem.name, "error");
  for (const Contender& contender : contenders) {
    fmt::print("{:>20}", contender.name);
  }
  fmt::print("{:>20}\n", "dop853/taylor");
  for (const double error : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-12, 1e-13}) {
    fmt::print("{:<8.0e}", error);
    for (const std::vector<Point>& of_one : points) {
      const std::optional<double> time = time_at(of_one, error);
      fmt::print("{:>20}", time ? fmt::format("{:.4f} ms", *time) : "-");
    }
    const auto series = time_at(points[0], error), rival = time_at(points[1], error);
    fmt::print("{:>20}\n", series && rival ? fmt::format("{:.2f}", *rival / *series) : "-");
  }
  return !points[0].empty() && points[0].back().error < 1e-8;
}

}  // namespace

}  // namespace bench::series

int main() {
  bool is_well = true;
  for (const bench::series::Problem& problem : bench::series::problems()) {
    is_well &= bench::series::show(problem);
  }
  return is_well ? 0 : 1;
}
