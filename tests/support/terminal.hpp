#pragma once
// A program in a pseudo-terminal, as a person sees and handles it.

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc::test {

inline constexpr std::string_view ctrl_c = "\x03";
inline constexpr std::string_view ctrl_d = "\x04";

class Terminal {
 public:
  Terminal(const std::string& program, const std::vector<std::string>& arguments, unsigned short columns = 80) {
    std::vector<char*> words = {const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) {
      words.push_back(const_cast<char*>(argument.c_str()));
    }
    words.push_back(nullptr);
    winsize size{24, columns, 0, 0};
    process_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ == 0) {
      execv(words[0], words.data());
      _exit(127);
    }
    if (process_ < 0) {
      throw std::runtime_error("no pseudo-terminal");
    }
  }
  ~Terminal() {
    if (process_ > 0) {
      kill(process_, SIGKILL);
      waitpid(process_, nullptr, 0);
    }
    close(terminal_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void type(std::string_view keys) {
    if (write(terminal_, keys.data(), keys.size()) != static_cast<ssize_t>(keys.size())) {
      throw std::runtime_error("the terminal takes no keys");
    }
  }
  void send(int signal) { kill(process_, signal); }

  /// Reads until `text` has appeared after what earlier calls have found; false at the end of the program or after
  /// `patience`.
  bool wait_for(std::string_view text, std::chrono::milliseconds patience = std::chrono::seconds(60)) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    for (;;) {
      if (const std::size_t place = seen_.find(text, found_); place != std::string::npos) {
        found_ = place + text.size();
        return true;
      }
      if (!read_some(deadline)) {
        return false;
      }
    }
  }

  /// Reads to the end of the program; its exit code, or minus the signal that ended it.
  int finish(std::chrono::milliseconds patience = std::chrono::seconds(60)) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (read_some(deadline)) {
    }
    if (std::chrono::steady_clock::now() >= deadline) {
      kill(process_, SIGKILL);
    }
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  /// Everything that the program has written, and the echo of what was typed. Lines end in "\r\n".
  const std::string& seen() const { return seen_; }

 private:
  bool read_some(std::chrono::steady_clock::time_point deadline) {
    using std::chrono::milliseconds;
    const auto left = std::chrono::duration_cast<milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd waiting{terminal_, POLLIN, 0};
    if (left.count() <= 0 || poll(&waiting, 1, static_cast<int>(left.count())) <= 0) {
      return false;
    }
    char bytes[4096];
    const ssize_t count = read(terminal_, bytes, sizeof bytes);  // fails when the program has ended
    seen_.append(bytes, count > 0 ? static_cast<std::size_t>(count) : 0);
    return count > 0;
  }

  pid_t process_ = -1;
  int terminal_ = -1;
  std::string seen_;
  std::size_t found_ = 0;
};

}  // namespace mbcc::test
