#include "source/text.hpp"

namespace mbcc {

namespace {

constexpr std::string_view blanks = " \t\r\n";

}  // namespace

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string one_line(std::string_view text) {
  std::string line;
  bool in_comment = false;
  for (const char c : text) {
    in_comment = c == '#' || (in_comment && c != '\n');
    const bool is_blank = blanks.find(c) != std::string_view::npos;
    if (is_blank && !line.empty() && line.back() != ' ') {
      line += ' ';
    } else if (!is_blank && !in_comment) {
      line += c;
    }
  }
  return line;
}

}  // namespace mbcc
