#include "row_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <iterator>
#include <limits>

namespace mbrt {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

/// Names of elements of several indices hold commas.
void append_quoted(std::string& text, std::string_view name) {
  if (name.find(',') == std::string_view::npos) {
    text += name;
  } else {
    fmt::format_to(std::back_inserter(text), "\"{}\"", name);
  }
}

void append_number(std::string& text, double value) {
  constexpr int significant_digits = std::numeric_limits<double>::max_digits10;
  char digits[32];
  const auto [end, error] =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, significant_digits);
  text.append(digits, end);
}

}  // namespace

std::string& RowFile::buffer() {
  if (buffer_.size() >= buffer_size) {
    flush();
  }
  return buffer_;
}

void RowFile::flush() {
  file_.write(buffer_);
  buffer_.clear();
}

bool RowFile::commit() {
  flush();
  return file_.commit();
}

CsvFile::CsvFile(std::string target, std::span<const std::string> names) : RowFile(std::move(target)) {
  std::string& text = buffer();
  for (const std::string& name : names) {
    append_quoted(text, name);
    text += ',';
  }
  text.back() = '\n';
}

void CsvFile::write_row(std::span<const double> row) {
  std::string& text = buffer();
  for (const double value : row) {
    append_number(text, value);
    text += ',';
  }
  text.back() = '\n';
}

NpyFile::NpyFile(std::string target, std::span<const std::string> names) : RowFile(std::move(target)) {
  constexpr char order = std::endian::native == std::endian::little ? '<' : '>';
  for (const std::string& name : names) {
    fmt::format_to(std::back_inserter(fields_), "('{}', '{}f8'), ", name, order);
  }
  buffer() += header();
}

void NpyFile::write_row(std::span<const double> row) {
  buffer().append(reinterpret_cast<const char*>(row.data()), row.size_bytes());
  ++rows_;
}

bool NpyFile::commit() {
  flush();
  file().rewrite_beginning(header());
  return RowFile::commit();
}

/// Version 2.0 of the form (numpy.lib.format): magic, version, length of the rest in four bytes, and a Python literal
/// that spaces bring to a multiple of 64 bytes. As long as ever the number of rows is: the data stays where it is.
std::string NpyFile::header() const {
  constexpr std::size_t alignment = 64, preamble = 12;
  std::string literal = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields_, rows_);
  const std::size_t longest =
      literal.size() - std::to_string(rows_).size() + std::numeric_limits<std::size_t>::digits10 + 1;
  const std::size_t size = (preamble + longest + 1 + alignment - 1) / alignment * alignment - preamble;
  literal.resize(size - 1, ' ');
  literal += '\n';
  std::string text = "\x93NUMPY\x02";
  text += '\0';
  for (int byte = 0; byte < 4; ++byte) {
    text += static_cast<char>(static_cast<std::uint32_t>(size) >> (8 * byte) & 0xffU);
  }
  return text + literal;
}

}  // namespace mbrt
