#pragma once
// A recorded result as columns.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace mbcc::figure {

/// What a run wrote with --csv: a header, and at least one row of numbers. The first column is `t`, wherever it stands
/// in the file.
struct Table {
  std::string name;                          ///< the file, as the user wrote it
  std::vector<std::string> names;            ///< of the columns, each once
  std::vector<std::vector<double>> columns;  ///< of one length; what was not finite is NaN or infinite

  /// Empty if there is no such column.
  std::span<const double> operator[](std::string_view column) const;
  std::span<const double> time() const { return columns.front(); }
};

/// Reads one of `sources`. Nothing, with a diagnostic at the first cell that is wrong, if it is no such file.
std::optional<Table> read_table(const Sources& sources, std::uint32_t file, Diagnostics& diagnostics);

}  // namespace mbcc::figure
