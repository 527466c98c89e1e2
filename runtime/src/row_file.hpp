#pragma once
// Rows of numbers under names, streamed into a file.

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "output_file.hpp"

namespace mbrt {

/// A file of one of the forms that a motion is recorded in. Its buffer aside it takes no memory, however many rows
/// come.
class RowFile {
 public:
  explicit RowFile(std::string target) : file_(std::move(target)) {}
  virtual ~RowFile() = default;
  RowFile(const RowFile&) = delete;
  RowFile& operator=(const RowFile&) = delete;

  virtual void write_row(std::span<const double> row) = 0;

  /// After the last row. False, and nothing left behind, if anything failed until then.
  virtual bool commit();

  /// Empty while all is well.
  const std::string& error() const { return file_.error(); }

 protected:
  /// Room for what one row adds; full buffers go to the file.
  std::string& buffer();
  void flush();
  OutputFile& file() { return file_; }

 private:
  OutputFile file_;
  std::string buffer_;
};

/// Comma-separated values: a line of names, then 17 significant digits for each number.
class CsvFile final : public RowFile {
 public:
  CsvFile(std::string target, std::span<const std::string> names);
  void write_row(std::span<const double> row) override;
};

/// NumPy's .npy: one array of records with a field of eight bytes for each name. The number of records is known last
/// and stands in the header, so that the file must be one in which one can go back.
class NpyFile final : public RowFile {
 public:
  NpyFile(std::string target, std::span<const std::string> names);
  void write_row(std::span<const double> row) override;
  bool commit() override;

 private:
  std::string header() const;

  std::string fields_;
  std::size_t rows_ = 0;
};

}  // namespace mbrt
