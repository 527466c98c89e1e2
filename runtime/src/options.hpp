#pragma once
// The command line of an emitted program.

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "mbrt/model.hpp"

namespace mbrt {

enum ExitCode : int { ExitFine = 0, ExitUsage = 2, ExitFailed = 3, ExitInterrupted = 130 };

/// A value given on the command line to parameter `index`, or to element `index` of the state.
struct Assignment {
  std::size_t index;
  double value;
};

/// Baumgarte's constants; 1, 1, 1 are those of R. M. M. Orsino's thesis.
struct Stabilization {
  double b1, b2, b3;
};

inline constexpr double default_tolerance = 1e-9;

/// What a run is asked to do; valid: times are finite, `to` >= `from`, `method` is one of `methods()`, `step` > 0 where
/// that has a constant one.
struct Options {
  double from = 0;
  double to = not_given;
  std::string method = "rk4";
  bool chosen_by_auto = false;
  double step = not_given;
  double tolerance = default_tolerance;
  bool project = false;
  std::optional<Stabilization> stabilization;
  double every = not_given;
  double cutoff = default_cutoff;
  std::vector<Assignment> parameters;
  std::vector<Assignment> initial;
  bool assemble = false;
  std::vector<std::size_t> fixed;  ///< elements of the state that assembling holds, besides those of `initial`
  std::string csv;                 ///< empty: no recording; `-`: standard output
  std::string npy;                 ///< empty: no recording
  bool residuals = false;          ///< record errors of constraints and the energy too
  std::string summary;             ///< empty: none; `-`: standard output
  bool quiet = false;
  bool progress = false;
  long repeat = 0;
};

/// Reads the command line over the model's defaults. Where there is nothing to run (wrong usage, `--help`) says so and
/// returns the exit code.
std::variant<Options, ExitCode> read_command_line(const Description& model, int argc, char** argv);

}  // namespace mbrt
