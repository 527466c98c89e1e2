#pragma once
// A broken invariant is a bug in mbcc, never the user's mistake: it is always checked and says so.

namespace mbcc {

/// Prints "this is a bug in mbcc" with the place and ends the program with exit code 70.
[[noreturn]] void broken_invariant(const char* condition, const char* file, int line);

}  // namespace mbcc

#define MBCC_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::mbcc::broken_invariant(#condition, __FILE__, __LINE__))
