#include "figure/table.hpp"

#include <algorithm>
#include <charconv>
#include <set>

namespace mbcc::figure {

namespace {

/// One line after the other, cut into cells.
class Rows {
 public:
  Rows(std::string_view text, std::uint32_t file) : text_(text), file_(file) {}

  /// Whether there is another line; its cells are then those of `cells()`. Their spans are without the quotes that a
  /// name with commas in it (`p[1,2].x`) stands in.
  bool next() {
    if (end_ == text_.size()) {
      return false;
    }
    begin_ = end_;
    const std::size_t stop = std::min(text_.find('\n', begin_), text_.size());
    end_ = std::min(stop + 1, text_.size());
    cut(stop > begin_ && text_[stop - 1] == '\r' ? stop - 1 : stop);
    return true;
  }

  const std::vector<Span>& cells() const { return cells_; }
  std::string_view text(Span cell) const { return text_.substr(cell.begin, cell.end - cell.begin); }
  Span line() const { return {file_, cells_.front().begin, cells_.back().end}; }

 private:
  void cut(std::size_t stop) {
    cells_.clear();
    for (std::size_t at = begin_;; ++at) {
      const bool quoted = at < stop && text_[at] == '"' && text_.substr(at + 1, stop - at - 1).find('"') != text_.npos;
      const std::size_t begin = quoted ? at + 1 : at;
      const std::size_t end = std::min(text_.find(quoted ? '"' : ',', begin), stop);
      cells_.push_back({file_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)});
      at = quoted ? std::min(text_.find(',', end), stop) : end;
      if (at == stop) {
        return;
      }
    }
  }

  std::string_view text_;
  std::uint32_t file_;
  std::size_t begin_ = 0, end_ = 0;  // of the line, its end included
  std::vector<Span> cells_;
};

constexpr std::string_view time_column = "t";

bool read_header(const Rows& rows, Table& table, Diagnostics& diagnostics) {
  std::set<std::string_view> seen;
  for (const Span cell : rows.cells()) {
    const std::string_view name = rows.text(cell);
    if (!seen.insert(name).second) {
      diagnostics.report(Finding::ColumnTwice, cell, name);
      return false;
    }
    table.names.emplace_back(name);
  }
  table.columns.resize(table.names.size());
  if (!seen.contains(time_column)) {
    diagnostics.report(Finding::ResultWithoutTime, rows.line());
    return false;
  }
  return true;
}

bool read_row(const Rows& rows, Table& table, Diagnostics& diagnostics) {
  if (rows.cells().size() != table.names.size()) {
    diagnostics.report(Finding::RaggedRow, rows.line(), rows.cells().size(), table.names.size());
    return false;
  }
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const std::string_view text = rows.text(rows.cells()[i]);
    double value = 0;
    const char* const end = text.data() + text.size();
    if (const auto [stop, error] = std::from_chars(text.data(), end, value); error != std::errc() || stop != end) {
      diagnostics.report(Finding::CellNotANumber, rows.cells()[i], text);
      return false;
    }
    table.columns[i].push_back(value);
  }
  return true;
}

void put_time_first(Table& table) {
  const auto time = std::find(table.names.begin(), table.names.end(), time_column) - table.names.begin();
  std::rotate(table.names.begin(), table.names.begin() + time, table.names.begin() + time + 1);
  std::rotate(table.columns.begin(), table.columns.begin() + time, table.columns.begin() + time + 1);
}

}  // namespace

std::span<const double> Table::operator[](std::string_view column) const {
  const auto found = std::find(names.begin(), names.end(), column);
  return found == names.end() ? std::span<const double>() : columns[static_cast<std::size_t>(found - names.begin())];
}

std::optional<Table> read_table(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics) {
  const Source& source = sources[file];
  Table table{source.name(), {}, {}};
  Rows rows(source.text(), file);
  if (!rows.next()) {
    diagnostics.report(Finding::ResultEmpty, {file, 0, 0});
    return std::nullopt;
  }
  if (!read_header(rows, table, diagnostics)) {
    return std::nullopt;
  }
  while (rows.next()) {
    if (!read_row(rows, table, diagnostics)) {
      return std::nullopt;
    }
  }
  put_time_first(table);
  if (table.time().empty()) {
    const auto end = static_cast<std::uint32_t>(source.text().size());
    diagnostics.report(Finding::ResultWithoutRows, {file, end, end});
    return std::nullopt;
  }
  return table;
}

}  // namespace mbcc::figure
