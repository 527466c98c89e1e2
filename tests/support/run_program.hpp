#pragma once
// Runs programs as a user does, in a directory of their own, and reads what they wrote.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc::test {

/// A new empty directory, removed with everything in it at the end of its life.
class ScratchDirectory {
 public:
  ScratchDirectory() {
    std::string pattern = (std::filesystem::temp_directory_path() / "mbcc_test_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) {
      throw std::runtime_error("no scratch directory at " + pattern);
    }
    path_ = pattern;
  }
  ~ScratchDirectory() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchDirectory(const ScratchDirectory&) = delete;
  ScratchDirectory& operator=(const ScratchDirectory&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

inline void write_file(const std::filesystem::path& path, std::string_view text) { std::ofstream(path) << text; }

/// A recorded result: named columns of equal length.
struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;

  [[nodiscard]] const std::vector<double>& operator[](const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      throw std::out_of_range("no column " + name);
    }
    return columns[static_cast<std::size_t>(found - names.begin())];
  }
  [[nodiscard]] std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }

  /// The value of `name` in the row recorded at `time`, or NaN if there is none within 1e-9.
  [[nodiscard]] double at(double time, const std::string& name) const {
    const std::vector<double>& t = (*this)["t"];
    for (std::size_t row = 0; row < t.size(); ++row) {
      if (std::abs(t[row] - time) < 1e-9) {
        return (*this)[name][row];
      }
    }
    return std::nan("");
  }
  [[nodiscard]] double last(const std::string& name) const { return (*this)[name].back(); }
};

/// The cells of one row; a cell in quotes may hold commas.
inline std::vector<std::string> cells(const std::string& row) {
  std::vector<std::string> found(1);
  bool in_quotes = false;
  for (const char c : row) {
    if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && !in_quotes) {
      found.emplace_back();
    } else {
      found.back() += c;
    }
  }
  return found;
}

/// Missing cells are NaN.
inline Table parse_csv(const std::string& text) {
  Table table;
  std::istringstream lines(text);
  std::string line;
  if (std::getline(lines, line)) {
    table.names = cells(line);
  }
  table.columns.resize(table.names.size());
  while (std::getline(lines, line)) {
    const std::vector<std::string> row = cells(line);
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      table.columns[i].push_back(i < row.size() ? std::strtod(row[i].c_str(), nullptr) : std::nan(""));
    }
  }
  return table;
}

/// What one command printed, and its exit code (-1: ended by a signal).
struct Outcome {
  int exit_code = -1;
  std::string output;
  std::string errors;
};

inline std::string quoted(const std::string& argument) {
  std::string text = "'";
  for (const char c : argument) {
    text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return text + "'";
}

/// Runs `program arguments...` to its end.
inline Outcome run_program(const std::string& program, const std::vector<std::string>& arguments) {
  const ScratchDirectory scratch;
  std::string command = quoted(program);
  for (const std::string& argument : arguments) {
    command += " " + quoted(argument);
  }
  const std::string output = scratch / "output";
  const std::string errors = scratch / "errors";
  const int status = std::system((command + " >" + quoted(output) + " 2>" + quoted(errors) + " </dev/null").c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(output), read_file(errors)};
}

}  // namespace mbcc::test
