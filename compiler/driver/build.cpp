#include "driver/build.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "driver/files.hpp"
#include "driver/process.hpp"
#include "emit/emit.hpp"

namespace mbcc {

namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Where the runtime is: beside an installed mbcc, or in the build that this mbcc comes from.
struct Runtime {
  fs::path include;
  fs::path library;
};

Runtime find_runtime() {
  std::error_code ignored;
  const fs::path prefix = fs::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  Runtime installed{prefix / MBCC_INSTALL_INCLUDEDIR, prefix / MBCC_INSTALL_LIBDIR / "libmbrt.a"};
  if (fs::exists(installed.include / "mbrt" / "simulation.hpp", ignored) && fs::exists(installed.library, ignored)) {
    return installed;
  }
  return {MBCC_BUILD_INCLUDE, MBCC_BUILD_LIBRARY};
}

fs::path cache_directory() {
  const std::string cache_home = environment("XDG_CACHE_HOME");
  const std::string home = environment("HOME");
  if (!cache_home.empty()) {
    return fs::path(cache_home) / "mbcc";
  }
  std::error_code ignored;
  return home.empty() ? fs::temp_directory_path(ignored) / fmt::format("mbcc-{}", getuid())
                      : fs::path(home) / ".cache" / "mbcc";
}

/// FNV-1a. It names a directory; the key itself is kept inside and compared, so that a collision does no harm.
std::string short_hash(std::string_view key) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : key) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }
  return fmt::format("{:016x}", hash);
}

/// The sizes and times of the files of the runtime.
std::string stamp(const Runtime& runtime) {
  std::vector<fs::path> files{runtime.library};
  std::error_code ignored;
  for (const fs::directory_entry& header : fs::directory_iterator(runtime.include / "mbrt", ignored)) {
    files.push_back(header.path());
  }
  std::sort(files.begin(), files.end());
  std::string text;
  for (const fs::path& file : files) {
    text += fmt::format("{} of {} bytes, {}\n", file.string(), fs::file_size(file, ignored),
                        fs::last_write_time(file, ignored).time_since_epoch().count());
  }
  return text;
}

/// Everything that the program depends on.
std::string cache_key(const std::string& source, const std::vector<std::string>& command, const Runtime& runtime) {
  return fmt::format("mbcc {}\n{}\n{}\n{}", version, fmt::join(command, " "), stamp(runtime), source);
}

}  // namespace

std::vector<std::string> split_words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

std::optional<std::vector<std::string>> find_cxx_compiler() {
  std::vector<std::string> command = split_words(environment("CXX"));
  if (command.empty()) {
    command = {"c++"};
  }
  return is_on_path(command.front()) ? std::optional(command) : std::nullopt;
}

BuildResult build_program(const std::string& source, const std::vector<std::string>& compiler,
                          const std::vector<std::string>& flags) {
  const Runtime runtime = find_runtime();
  std::vector<std::string> command = compiler;
  command.emplace_back("-std=c++20");
  command.insert(command.end(), flags.begin(), flags.end());
  for (const std::string& flag : split_words(MBCC_RUNTIME_FLAGS)) {
    command.push_back(flag);
  }
  command.push_back("-I" + runtime.include.string());

  const std::string key = cache_key(source, command, runtime);
  const fs::path directory = cache_directory() / short_hash(key);
  const fs::path program = directory / "simulation";
  std::error_code failure;
  if (fs::exists(program, failure) && read_file((directory / "key").string()) == key) {
    return {program.string(), "", false};
  }
  fs::create_directories(directory, failure);
  const std::string unfinished = fmt::format("unfinished-{}", getpid());
  const fs::path built = directory / unfinished;
  const fs::path source_file = directory / (unfinished + ".cpp");
  const fs::path log = directory / (unfinished + ".log");
  if (failure || !write_file(source_file.string(), source)) {
    return {"", fmt::format("cannot write to the cache directory `{}`\n", directory.string()), false};
  }
  for (const std::string& word : {source_file.string(), std::string("-o"), built.string(), runtime.library.string()}) {
    command.push_back(word);
  }
  const ProcessEnd compiler_end = run_process(command, log.string());
  const bool compiled = compiler_end.exit_code == 0;
  BuildResult result{"", compiled ? "" : read_file(log.string()).value_or(""), compiler_end.interrupted};
  std::error_code ignored;
  if (compiled) {
    // The key is in place before the program: who finds the program finds its key.
    const bool keyed = write_file((directory / "key").string(), key);
    fs::rename(built, program, failure);
    result.program = keyed && !failure ? program.string() : "";
  }
  for (const fs::path& rest : {source_file, log, built}) {
    fs::remove(rest, ignored);
  }
  return result;
}

}  // namespace mbcc
