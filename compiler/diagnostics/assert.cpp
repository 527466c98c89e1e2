#include "diagnostics/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace mbcc {

void broken_invariant(const char* condition, const char* file, int line) {
  constexpr int exit_code_of_a_bug = 70;  // EX_SOFTWARE of sysexits.h, and the contract of the command line
  std::fprintf(stderr, "mbcc: this is a bug in mbcc, please report it: `%s` does not hold (%s:%d)\n", condition, file,
               line);
  std::exit(exit_code_of_a_bug);
}

}  // namespace mbcc
