#include "emit/templates.hpp"

#include <algorithm>
#include <set>

#include "diagnostics/assert.hpp"

namespace mbcc::cpp {

namespace {

/// Every line of `block` behind `indentation`; a line that is empty stays empty.
std::string indented(std::string_view block, std::string_view indentation) {
  std::string result;
  while (!block.empty()) {
    const std::size_t end = block.find('\n');
    const std::string_view line = block.substr(0, end);
    if (!line.empty()) {
      result.append(indentation).append(line);
    }
    result += '\n';
    block = end == std::string_view::npos ? std::string_view{} : block.substr(end + 1);
  }
  return result;
}

/// The name in `@name@` at the start of `text`, or nothing.
std::string_view place_at(std::string_view text) {
  const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_", 1);
  return text.front() == '@' && end != std::string_view::npos && end > 1 && text[end] == '@' ? text.substr(1, end - 1)
                                                                                             : std::string_view{};
}

}  // namespace

std::string fill(std::string_view text, const Values& values) {
  std::string result;
  std::set<std::string_view> used;
  const auto value_of = [&](std::string_view place) -> const std::string& {
    const auto found = values.find(place);
    MBCC_ASSERT(found != values.end());
    used.insert(found->first);
    return found->second;
  };
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    const std::size_t first = line.find_first_not_of(' ');
    if (first != std::string_view::npos && line[first] == '@') {
      const std::string_view place = place_at(line.substr(first));
      if (!place.empty() && line.substr(first + place.size() + 2) == "\n") {
        result += indented(value_of(place), line.substr(0, first));
        continue;
      }
    }
    while (!line.empty()) {
      const std::string_view place = place_at(line);
      result += place.empty() ? std::string(1, line.front()) : value_of(place);
      line.remove_prefix(place.empty() ? 1 : place.size() + 2);
    }
  }
  MBCC_ASSERT(used.size() == values.size());
  return result;
}

}  // namespace mbcc::cpp
