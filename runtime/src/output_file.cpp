#include "output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace mbrt {

namespace fs = std::filesystem;

OutputFile::OutputFile(std::string target) : target_(std::move(target)) {
  if (target_ == "-") {
    file_ = stdout;
    return;
  }
  std::error_code ignored;
  const fs::path resolved = fs::weakly_canonical(target_, ignored);  // a link stays, what it points to is replaced
  const std::string path = resolved.empty() ? target_ : resolved.string();
  if (!fs::exists(path, ignored) || fs::is_regular_file(path, ignored)) {
    temporary_ = fmt::format("{}.{}.tmp", path, ::getpid());
    target_ = path;
  }
  file_ = std::fopen(temporary_.empty() ? target_.c_str() : temporary_.c_str(), "w");
  if (file_ == nullptr) {
    fail();
  }
}

OutputFile::~OutputFile() {
  if (file_ != nullptr && file_ != stdout) {
    std::fclose(file_);
    if (!temporary_.empty()) {
      std::remove(temporary_.c_str());
    }
  }
}

void OutputFile::write(std::string_view text) {
  if (error_.empty() && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    fail();
  }
}

void OutputFile::rewrite_beginning(std::string_view text) {
  if (error_.empty() && std::fseek(file_, 0, SEEK_SET) != 0) {
    fail();
  }
  write(text);
}

bool OutputFile::commit() {
  if (error_.empty() && std::fflush(file_) != 0) {
    fail();
  }
  if (!error_.empty() || file_ == stdout) {
    return error_.empty();
  }
  const bool closed = std::fclose(std::exchange(file_, nullptr)) == 0;
  if (!closed || (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0)) {
    fail();
    std::remove(temporary_.c_str());
  }
  return error_.empty();
}

void OutputFile::fail() {
  if (error_.empty()) {
    error_ = fmt::format("cannot write `{}`: {}", target_, std::strerror(errno));
  }
}

}  // namespace mbrt
