#pragma once
// A result file that appears whole: written beside its target and renamed when it is complete.

#include <cstdio>
#include <string>
#include <string_view>

namespace mbrt {

/// Failures (unwritable place, full disk) stay with the file: `error()` says what went wrong first.
class OutputFile {
 public:
  /// `-` is standard output. What exists and is no regular file (a device, a pipe) is written in place.
  explicit OutputFile(std::string target);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);

  /// Writes over what the file begins with, which must be as long. Fails where one cannot go back (a pipe).
  void rewrite_beginning(std::string_view text);

  /// Gives the file its name. False, and nothing left behind, if anything failed until then.
  bool commit();

  /// Empty while all is well.
  const std::string& error() const { return error_; }

 private:
  void fail();

  std::string target_;
  std::string temporary_;  // empty: written in place
  std::FILE* file_ = nullptr;
  std::string error_;
};

}  // namespace mbrt
