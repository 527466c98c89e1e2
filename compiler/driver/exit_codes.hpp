#pragma once
// What mbcc tells its caller; 3 (run-time failure) comes from the simulations that it runs.

namespace mbcc {

enum ExitCode : int {
  exit_fine = 0,
  exit_wrong_model = 1,  ///< or a check failed
  exit_wrong_usage = 2,  ///< unreadable input and unwritable output included
  exit_mbcc_bug = 70,    ///< emitted code that the C++ compiler rejects included
  exit_interrupted = 130,
};

}  // namespace mbcc
