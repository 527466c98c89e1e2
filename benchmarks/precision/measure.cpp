#include "precision/measure.hpp"

#include <algorithm>
#include <cmath>

#include "thread_clock.hpp"

namespace bench::precision {

namespace {

double error_of(const std::vector<double>& end, const Problem& problem) {
  double largest = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const double error = std::abs(end[i] - problem.end[i].value);
    largest = error <= largest ? largest : error;  // NaN stays
  }
  return largest;
}

}  // namespace

std::vector<Point> measure(const std::vector<Contender>& contenders, const Problem& problem, Effort effort) {
  constexpr double enough = 0.02;  // seconds that a point is worth
  constexpr double astray = 0.1;
  std::vector<Point> points;
  for (int sample = 0; sample < effort.samples; ++sample) {
    std::size_t at = 0;
    for (const Contender& contender : contenders) {
      bool is_slow = false;
      for (const double setting : contender.settings) {
        if (is_slow) {
          break;
        }
        const bool is_new = sample == 0;
        if (is_new || sample * points[at].seconds < enough) {
          const double begin = thread_seconds();
          const std::vector<double> end = contender.integrate(setting);
          const double taken = thread_seconds() - begin;
          if (is_new) {
            points.push_back({contender.name, setting, taken, error_of(end, problem)});
          }
          points[at].seconds = std::min(points[at].seconds, taken);
        }
        // What has gone astray may take long, and a finer setting less.
        is_slow = points[at].seconds > (points[at].error < astray ? 1 : 5) * effort.patience;
        ++at;
      }
    }
  }
  return points;
}

}  // namespace bench::precision
