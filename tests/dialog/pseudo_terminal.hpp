#pragma once
// A program on a pseudo-terminal, used as a person would: look, then type.

#include <sys/types.h>

#include <string>
#include <vector>

#include "screen.hpp"

namespace mbcc::test {

class PseudoTerminal {
 public:
  /// Starts `command` in `directory`.
  PseudoTerminal(const std::vector<std::string>& command, const std::string& directory);
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  /// Types `keys` once the line of the cursor reads `line`, below the line where something was typed before. A test
  /// that waits in vain throws, with what is to be seen.
  void answer(const std::string& line, const std::string& keys);

  /// Waits for the end of the program; its exit code.
  int finish();

  [[nodiscard]] std::string text() const { return screen_.text(); }

 private:
  /// Shows what the program prints next; false if it has ended.
  bool look();

  pid_t child_ = -1;
  int terminal_ = -1;
  Screen screen_;
  std::size_t answered_ = 0;  ///< lines that there were when something was typed
};

}  // namespace mbcc::test
