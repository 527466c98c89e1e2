#pragma once
// Programs that mbcc starts and waits for.

#include <string>
#include <vector>

namespace mbcc {

/// Whether `program`, a path or a name, is one that can be started.
bool is_on_path(const std::string& program);

struct ProcessEnd {
  int exit_code = 127;       ///< 127: it could not be started; 128 + n: signal n ended it
  bool interrupted = false;  ///< mbcc was asked to stop meanwhile, and the program did not end well
};

/// Runs `command`, a program of the PATH and its arguments, to its end, with both its outputs in the file `log`, or
/// where mbcc's are if that is empty. A SIGINT or SIGTERM for mbcc is the program's meanwhile: it ends, or does not,
/// and mbcc can put its files in order.
ProcessEnd run_process(const std::vector<std::string>& command, const std::string& log = "");

}  // namespace mbcc
