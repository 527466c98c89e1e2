#pragma once
// Runs the real mbcc as a user does, in a directory of its own, and reads what it wrote. The test target defines
// MBCC_BINARY, the path of the program.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
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

inline Outcome run_mbcc(const std::vector<std::string>& arguments) { return run_program(MBCC_BINARY, arguments); }

/// A finished `mbcc run`: its outcome, its rows, and its summary (null if it wrote none).
struct Run : Outcome {
  Table table;
  nlohmann::json summary;

  /// The largest absolute value that the monitors saw; `level` is "position", "velocity" or "acceleration".
  [[nodiscard]] double constraint_error(const std::string& name, const std::string& level) const {
    return summary.at("constraints").at(name).at(level).get<double>();
  }
  [[nodiscard]] double final_value(const std::string& name) const { return summary.at("final").at(name).get<double>(); }
};

/// `mbcc run model --csv ... --summary ... flags...`.
inline Run run_model(const std::filesystem::path& model, const std::vector<std::string>& flags = {}) {
  const ScratchDirectory scratch;
  std::vector<std::string> arguments = {"run",       model.string(),          "--csv", scratch / "result.csv",
                                        "--summary", scratch / "summary.json"};
  arguments.insert(arguments.end(), flags.begin(), flags.end());
  Run run{run_mbcc(arguments), {}, {}};
  run.table = parse_csv(read_file(scratch / "result.csv"));
  run.summary = nlohmann::json::parse(read_file(scratch / "summary.json"), nullptr, false);
  if (run.summary.is_discarded()) {
    run.summary = nullptr;
  }
  return run;
}

}  // namespace mbcc::test
