#include "driver/process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <sstream>

extern char** environ;

namespace mbcc {

namespace {

bool is_program(const std::filesystem::path& path) {
  return access(path.c_str(), X_OK) == 0 && !std::filesystem::is_directory(path);
}

/// Holds SIGINT, SIGTERM and SIGCHLD back while this lives, for `wait` to take.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) {
      sigaddset(&held_, signal);
    }
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
  }
  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

  const sigset_t& before() const { return before_; }
  int wait(siginfo_t& info) const { return sigwaitinfo(&held_, &info); }

 private:
  sigset_t held_{}, before_{};
};

/// 0, or the reason why there is no child.
int spawn(const std::vector<std::string>& command, const std::string& log, const sigset_t& mask, pid_t& child) {
  std::vector<char*> arguments;
  for (const std::string& word : command) {
    arguments.push_back(const_cast<char*>(word.c_str()));
  }
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (!log.empty()) {
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  }
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setsigmask(&attributes, &mask);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
  const int failure = posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failure;
}

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

bool is_on_path(const std::string& program) {
  if (program.find('/') != std::string::npos) {
    return is_program(program);
  }
  const char* const search = std::getenv("PATH");
  std::istringstream path(search == nullptr ? "" : search);
  for (std::string directory; std::getline(path, directory, ':');) {
    if (is_program(std::filesystem::path(directory.empty() ? "." : directory) / program)) {
      return true;
    }
  }
  return false;
}

ProcessEnd run_process(const std::vector<std::string>& command, const std::string& log) {
  const HeldSignals signals;
  ProcessEnd end;
  pid_t child = 0;
  if (spawn(command, log, signals.before(), child) != 0) {
    return end;
  }
  bool asked_to_stop = false;
  for (;;) {
    siginfo_t info{};
    const int signal = signals.wait(info);
    if (signal == SIGINT || signal == SIGTERM) {
      asked_to_stop = true;
      if (info.si_code != SI_KERNEL) {  // a terminal sends its signals to the child as well
        kill(child, signal);
      }
    }
    int status = 0;
    if (const pid_t ended = waitpid(child, &status, WNOHANG); ended != 0) {
      end.exit_code = ended == child ? exit_code_of(status) : end.exit_code;
      end.interrupted = asked_to_stop && end.exit_code != 0;
      return end;
    }
  }
}

}  // namespace mbcc
