#pragma once
// How far a run is, on standard error, while it runs.

#include <chrono>

namespace mbrt {

/// A bar with the time that remains, redrawn in place and taken away at the end, so that the report follows in its
/// stead. Where standard error is no terminal: a line a second, and one at the end.
class Progress {
 public:
  enum class From { FirstStep, FirstSecond };

  /// Whether somebody at a terminal may want to see how a long run goes.
  static bool has_watcher();

  Progress(double from, double to, From shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// At every accepted step. Asks the clock every now and then only: a clock costs as much as a small model.
  void reached(double time) {
    time_ = time;
    if (--steps_until_asked_ <= 0) {
      ask_clock();
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  void ask_clock();
  void show();

  const double from_;
  const double to_;
  const bool on_terminal_;
  const From shown_from_;
  const Clock::time_point begin_ = Clock::now();
  Clock::time_point asked_ = begin_;
  Clock::time_point next_show_;
  double time_;
  long stride_ = 1;  // steps between two looks at the clock
  long steps_until_asked_ = 1;
  bool visible_ = false;
};

}  // namespace mbrt
