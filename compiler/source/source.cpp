#include "source/source.hpp"

#include <algorithm>
#include <utility>

namespace mbcc {

Span join(Span first, Span last) { return {first.file, first.begin, std::max(first.end, last.end)}; }

Source::Source(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {
  line_starts_.push_back(0);
  for (std::uint32_t at = 0; at < text_.size(); ++at) {
    if (text_[at] == '\n') {
      line_starts_.push_back(at + 1);
    }
  }
}

std::string_view Source::line(std::uint32_t number) const {
  const std::uint32_t begin = line_starts_[number - 1];
  const std::size_t end = text_.find('\n', begin);
  std::string_view line = text().substr(begin, end == std::string::npos ? end : end - begin);
  if (!line.empty() && line.back() == '\r') {
    line.remove_suffix(1);
  }
  return line;
}

Position Source::position(std::uint32_t offset) const {
  const auto after = std::upper_bound(line_starts_.begin(), line_starts_.end(), offset);
  const auto line = static_cast<std::uint32_t>(after - line_starts_.begin());
  return {line, offset - line_starts_[line - 1] + 1};
}

std::uint32_t Sources::add(std::string name, std::string text) {
  files_.emplace_back(std::move(name), std::move(text));
  return static_cast<std::uint32_t>(files_.size() - 1);
}

std::string_view Sources::text(Span span) const {
  return files_[span.file].text().substr(span.begin, span.end - span.begin);
}

Position Sources::position(Span span) const { return files_[span.file].position(span.begin); }

std::string Sources::place(Span span) const {
  const std::string& name = files_[span.file].name();
  const std::size_t slash = name.find_last_of('/');
  const std::string base = slash == std::string::npos ? name : name.substr(slash + 1);
  return base + ":" + std::to_string(position(span).line);
}

}  // namespace mbcc
