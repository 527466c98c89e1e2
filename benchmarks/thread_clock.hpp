#pragma once
// The clock of all measurements: it stands still while another process has the core.

#include <time.h>

namespace bench {

/// Seconds of processor time that this thread has had.
inline double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace bench
