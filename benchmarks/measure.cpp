#include "measure.hpp"

#include <time.h>

#include <algorithm>
#include <cmath>

namespace bench {

namespace {

/// Seconds of processor time that this thread has had.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The compiler must take it that all memory has been read and written here.
void keep() { asm volatile("" ::: "memory"); }

/// One sample's work: `steps` steps from the start, `repetitions` times.
struct Workload {
  long steps;
  long repetitions;
};

struct Sample {
  double seconds;
  long evaluations;
};

Sample run(const Scene& scene, const Contender& contender, Workload workload) {
  std::vector<double> state;
  Sample sample{0, 0};
  const double begin = thread_seconds();
  for (long i = 0; i < workload.repetitions; ++i) {
    state = scene.start;
    keep();
    sample.evaluations += contender.integrate(state, scene.step, workload.steps);
    keep();
  }
  sample.seconds = thread_seconds() - begin;
  return sample;
}

Workload workload_of(const Scene& scene, const Contender& contender, double seconds) {
  const long steps = affordable_steps(scene, contender, seconds);
  const double once = run(scene, contender, {steps, 1}).seconds;
  return {steps, std::max(1L, std::lround(seconds / once))};
}

Timing summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front()};
}

}  // namespace

std::vector<double> state_after(const Scene& scene, const Contender& contender, long steps) {
  std::vector<double> state = scene.start;
  contender.integrate(state, scene.step, steps);
  return state;
}

long affordable_steps(const Scene& scene, const Contender& contender, double seconds) {
  long steps = 1;
  for (;;) {
    const double taken = run(scene, contender, {steps, 1}).seconds;
    if (steps == scene.steps || 2 * taken > seconds) {
      return steps;
    }
    steps = std::min(2 * steps, scene.steps);
  }
}

std::vector<Timing> measure(const Scene& scene, std::span<const Contender> contenders, Effort effort) {
  std::vector<Workload> workloads;
  for (const Contender& contender : contenders) {
    workloads.push_back(workload_of(scene, contender, effort.sample_seconds));
  }
  std::vector<std::vector<double>> nanoseconds(contenders.size());
  for (int i = 0; i < effort.samples; ++i) {
    for (std::size_t k = 0; k < contenders.size(); ++k) {
      const Sample sample = run(scene, contenders[k], workloads[k]);
      nanoseconds[k].push_back(1e9 * sample.seconds / static_cast<double>(sample.evaluations));
    }
  }
  std::vector<Timing> timings;
  for (std::vector<double>& values : nanoseconds) {
    timings.push_back(summarise(std::move(values)));
  }
  return timings;
}

}  // namespace bench
