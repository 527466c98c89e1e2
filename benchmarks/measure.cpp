#include "measure.hpp"

#include <algorithm>
#include <cmath>

#include "thread_clock.hpp"

namespace bench {

namespace {

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

Sample run(const Subject& subject, Workload workload) {
  std::vector<double> state;
  Sample sample{0, 0};
  const double begin = thread_seconds();
  for (long i = 0; i < workload.repetitions; ++i) {
    state = subject.scene.start;
    keep();
    sample.evaluations += subject.contender.integrate(state, subject.scene.step, workload.steps);
    keep();
  }
  sample.seconds = thread_seconds() - begin;
  return sample;
}

Workload workload_of(const Subject& subject, double seconds) {
  const long steps = affordable_steps(subject, seconds);
  const double once = run(subject, {steps, 1}).seconds;
  return {steps, std::max(1L, std::lround(seconds / once))};
}

Timing summarise(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return {values[values.size() / 2], values.front()};
}

}  // namespace

std::vector<double> state_after(const Subject& subject, long steps) {
  std::vector<double> state = subject.scene.start;
  subject.contender.integrate(state, subject.scene.step, steps);
  return state;
}

long affordable_steps(const Subject& subject, double seconds) {
  long steps = 1;
  for (;;) {
    const double taken = run(subject, {steps, 1}).seconds;
    if (steps == subject.scene.steps || 2 * taken > seconds) {
      return steps;
    }
    steps = std::min(2 * steps, subject.scene.steps);
  }
}

std::vector<Timing> measure(std::span<const Subject> subjects, Effort effort) {
  std::vector<Workload> workloads;
  for (const Subject& subject : subjects) {
    workloads.push_back(workload_of(subject, effort.sample_seconds));
  }
  std::vector<std::vector<double>> nanoseconds(subjects.size());
  for (int i = 0; i < effort.samples; ++i) {
    for (std::size_t k = 0; k < subjects.size(); ++k) {
      const Sample sample = run(subjects[k], workloads[k]);
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
