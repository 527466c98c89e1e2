// A broken invariant ends the program with the exit code of a bug.

#include "diagnostics/assert.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <string>

namespace {

struct Ended {
  int exit_code;
  std::string errors;
};

/// Runs the body in a process of its own.
template <class Body>
Ended run_apart(const Body& body) {
  std::array<int, 2> pipe_ends{};
  REQUIRE(pipe(pipe_ends.data()) == 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    dup2(pipe_ends[1], STDERR_FILENO);
    body();
    _exit(0);
  }
  close(pipe_ends[1]);
  Ended ended{};
  char byte = 0;
  while (read(pipe_ends[0], &byte, 1) == 1) {
    ended.errors += byte;
  }
  close(pipe_ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  ended.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ended;
}

}  // namespace

TEST_CASE("an invariant that holds costs nothing") {
  const Ended ended = run_apart([] { MBCC_ASSERT(1 + 1 == 2); });
  CHECK(ended.exit_code == 0);
  CHECK(ended.errors.empty());
}

TEST_CASE("a broken invariant says that it is a bug in mbcc, and where") {
  const Ended ended = run_apart([] { MBCC_ASSERT(1 + 1 == 3); });
  CHECK(ended.exit_code == 70);
  CHECK(ended.errors.find("this is a bug in mbcc") != std::string::npos);
  CHECK(ended.errors.find("`1 + 1 == 3` does not hold") != std::string::npos);
  CHECK(ended.errors.find("assert_test.cpp:") != std::string::npos);
}
