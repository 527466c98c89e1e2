#include "driver/files.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

namespace mbcc {

namespace fs = std::filesystem;

std::optional<std::string> read_file(const std::string& path) {
  if (path == "-") {
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
  }
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return std::nullopt;
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  std::string text(std::istreambuf_iterator<char>(file), {});
  return file.bad() ? std::nullopt : std::optional(std::move(text));
}

bool write_file(const std::string& path, std::string_view text) {
  if (path == "-") {
    return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  }
  std::error_code failure;
  if (fs::exists(path, failure) && !fs::is_regular_file(path, failure)) {  // /dev/stdout, a pipe
    std::ofstream device(path, std::ios::binary);
    return static_cast<bool>(device << text << std::flush);
  }
  const std::string temporary = path + ".tmp" + std::to_string(getpid());
  {
    std::ofstream file(temporary, std::ios::binary);
    if (!(file << text) || !file.flush()) {
      file.close();
      fs::remove(temporary, failure);
      return false;
    }
  }
  fs::rename(temporary, path, failure);
  if (failure) {
    std::error_code ignored;
    fs::remove(temporary, ignored);
    return false;
  }
  return true;
}

ScratchFile::ScratchFile(std::string_view text) {
  std::error_code ignored;
  path_ = (fs::temp_directory_path(ignored) / "mbcc_XXXXXX").string();
  const int file = mkstemp(path_.data());
  if (file == -1) {
    path_.clear();
    return;
  }
  close(file);
  std::ofstream(path_, std::ios::binary) << text;
}

ScratchFile::~ScratchFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

TemporaryFile::TemporaryFile(const std::string& target, std::string_view ending)
    : path_(target + "." + std::to_string(getpid()) + "." + std::string(ending)) {}

TemporaryFile::~TemporaryFile() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

std::string relative_to_file(const std::string& file, const std::string& path) {
  const fs::path wanted(path);
  return (wanted.is_absolute() ? wanted : fs::path(file).parent_path() / wanted).lexically_normal().string();
}

}  // namespace mbcc
