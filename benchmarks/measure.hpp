#pragma once
// Timing of several contenders side by side.

#include <span>
#include <vector>

#include "contender.hpp"
#include "scene.hpp"

namespace bench {

/// Nanoseconds per evaluation of the right-hand side, the method's own work included.
struct Timing {
  double median;
  double minimum;
};

/// How much is measured: `samples` of each subject, each of at least `sample_seconds` where one step takes less.
struct Effort {
  int samples;
  double sample_seconds;
};

/// What is timed: a contender on its scene.
struct Subject {
  Scene scene;
  Contender contender;
};

/// One sample of each subject in turn, again and again, so that what slows the machine slows all of them. The clock
/// is the thread's own, which stands still while another process has the core.
std::vector<Timing> measure(std::span<const Subject> subjects, Effort effort);

/// The state after `steps` steps from the scene's start.
std::vector<double> state_after(const Subject& subject, long steps);

/// How many steps of its scene a subject makes in about `seconds`; at least one, at most all.
long affordable_steps(const Subject& subject, double seconds);

}  // namespace bench
