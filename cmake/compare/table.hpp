#pragma once
// A recorded trajectory: a CSV file with a header, numbers only, and time in the column `t`.

#include <cstddef>
#include <string>
#include <vector>

namespace mbcc::compare {

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;  ///< each as long as `names`
};

/// Throws std::runtime_error, naming file and line, when the file cannot be read, has no rows or is no such table.
Table read_table(const std::string& path);

/// Index of the column called `name`, or names.size().
std::size_t column(const Table& table, const std::string& name);

}  // namespace mbcc::compare
