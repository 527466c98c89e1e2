#include "screen.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

namespace mbcc::test {

void Screen::print(std::string_view bytes) {
  for (const char c : bytes) {
    if (sequence_.empty() && c != '\x1b') {
      put(c);
      continue;
    }
    sequence_ += c;
    const bool ends = sequence_.size() > 2 && c >= '@' && c <= '~';
    if (sequence_.size() > 1 && sequence_[1] != '[') {
      throw std::runtime_error("an escape sequence that this screen does not know");
    }
    if (ends) {
      control(std::string_view(sequence_).substr(2, sequence_.size() - 3), c);
      sequence_.clear();
    }
  }
}

void Screen::put(char c) {
  switch (c) {
    case '\r':
      column_ = 0;
      break;
    case '\n':
      lines_.emplace_back();
      break;
    case '\b':
      column_ -= column_ > 0 ? 1 : 0;
      break;
    case '\a':
    case '\0':  // padding
      break;
    default:
      lines_.back().resize(std::max(lines_.back().size(), column_ + 1), ' ');
      lines_.back()[column_++] = c;
  }
}

void Screen::control(std::string_view parameters, char command) {
  const std::size_t count = parameters.empty() ? 1 : std::strtoul(std::string(parameters).c_str(), nullptr, 10);
  switch (command) {
    case 'm':  // colours
      break;
    case 'C':
      column_ += count;
      break;
    case 'D':
      column_ -= std::min(column_, count);
      break;
    case 'K':
    case 'J':
      lines_.back().resize(std::min(lines_.back().size(), column_));
      break;
    default:
      throw std::runtime_error(std::string("a control sequence that this screen does not know: ") + command);
  }
}

std::string Screen::text() const {
  std::string all;
  for (const std::string& line : lines_) {
    all += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return all;
}

}  // namespace mbcc::test
