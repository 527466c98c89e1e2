#pragma once
// Files and paths, as the driver needs them.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace mbcc {

/// The whole text of a file, `-` being standard input; nothing if it cannot be read.
std::optional<std::string> read_file(const std::string& path);

/// Replaces `path` by a file of that text, or leaves the old one as it was and returns false. `-` is standard output.
bool write_file(const std::string& path, std::string_view text);

/// A file for another program to read, among the system's temporary files and as long as this lives.
class ScratchFile {
 public:
  explicit ScratchFile(std::string_view text);
  ~ScratchFile();
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;  ///< empty if it could not be written
};

/// A name beside `target` for a file that is gone at the end of this one's life if it has not been renamed.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& target, std::string_view ending);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// `path` as seen from the directory of `file`.
std::string relative_to_file(const std::string& file, const std::string& path);

}  // namespace mbcc
