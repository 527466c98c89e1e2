#include "pseudo_terminal.hpp"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace mbcc::test {

namespace {

constexpr int patience = 20000;  // ms: far longer than a loaded machine needs for the next prompt, builds included

[[noreturn]] void become(const std::vector<std::string>& command, const std::string& directory) {
  std::vector<char*> arguments;
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  setenv("TERM", "vt100", 1);
  setenv("HOME", directory.c_str(), 1);  // nobody's ~/.editrc
  if (chdir(directory.c_str()) == 0) {
    execv(arguments[0], arguments.data());
  }
  _exit(127);
}

}  // namespace

PseudoTerminal::PseudoTerminal(const std::vector<std::string>& command, const std::string& directory) {
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 200;  // no line of a test is longer
  child_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (child_ == 0) {
    become(command, directory);
  }
  if (child_ < 0) {
    throw std::runtime_error("no pseudo-terminal");
  }
}

PseudoTerminal::~PseudoTerminal() {
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  close(terminal_);
}

bool PseudoTerminal::look() {
  pollfd event{terminal_, POLLIN, 0};
  if (poll(&event, 1, patience) <= 0) {
    throw std::runtime_error("nothing happens any more:\n" + screen_.text());
  }
  std::array<char, 4096> bytes{};
  const ssize_t count = read(terminal_, bytes.data(), bytes.size());
  screen_.print({bytes.data(), count > 0 ? static_cast<std::size_t>(count) : 0});
  return count > 0;
}

void PseudoTerminal::answer(const std::string& line, const std::string& keys) {
  while (screen_.lines() == answered_ || screen_.before_cursor() != line) {
    if (!look()) {
      throw std::runtime_error("`" + line + "` does not come:\n" + screen_.text());
    }
  }
  answered_ = screen_.lines();
  if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
    throw std::runtime_error("nobody reads what is typed");
  }
}

int PseudoTerminal::finish() {
  while (look()) {
  }
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace mbcc::test
