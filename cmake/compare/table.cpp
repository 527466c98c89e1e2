#include "table.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <stdexcept>

namespace mbcc::compare {
namespace {

/// Cells of one line. A cell in double quotes may contain commas, as the name of `p[1,2].x` does.
std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '\r') {
      cells.back() += c;
    }
  }
  return cells;
}

double number(const std::string& cell, const std::string& place) {
  const char* const end = cell.data() + cell.size();
  double value = 0;
  if (const auto [stop, error] = std::from_chars(cell.data(), end, value); error != std::errc() || stop != end) {
    throw std::runtime_error(place + ": `" + cell + "` is not a number");
  }
  return value;
}

}  // namespace

Table read_table(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) {
    throw std::runtime_error(path + ": cannot be read");
  }
  Table table{split(line), {}};
  for (std::size_t number_of_line = 2; std::getline(file, line); ++number_of_line) {
    const std::string place = path + ":" + std::to_string(number_of_line);
    const std::vector<std::string> cells = split(line);
    if (cells.size() != table.names.size()) {
      throw std::runtime_error(place + ": " + std::to_string(cells.size()) + " cells under " +
                               std::to_string(table.names.size()) + " names");
    }
    std::vector<double>& row = table.rows.emplace_back();
    std::transform(cells.begin(), cells.end(), std::back_inserter(row),
                   [&](const std::string& cell) { return number(cell, place); });
  }
  if (table.rows.empty()) {
    throw std::runtime_error(path + ": has no rows");
  }
  return table;
}

std::size_t column(const Table& table, const std::string& name) {
  return static_cast<std::size_t>(std::find(table.names.begin(), table.names.end(), name) - table.names.begin());
}

}  // namespace mbcc::compare
