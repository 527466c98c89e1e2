#include "dialog/revision.hpp"

#include <algorithm>
#include <tuple>

#include "diagnostics/assert.hpp"

namespace mbcc::dialog {

Span Revision::lines_of(Span statement) const {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t last_before = text_.substr(0, statement.begin).find_last_not_of(blanks);
  if (last_before == std::string_view::npos || text_[last_before] == '\n') {
    statement.begin = last_before == std::string_view::npos ? 0 : static_cast<std::uint32_t>(last_before + 1);
  }
  const std::size_t next = text_.find_first_not_of(blanks, statement.end);
  if (next == std::string_view::npos || text_[next] == '#' || text_[next] == '\n') {
    statement.end = static_cast<std::uint32_t>(std::min(text_.find('\n', statement.end), text_.size() - 1) + 1);
  }
  return statement;
}

Piece Revision::result() {
  std::stable_sort(changes_.begin(), changes_.end(), [](const Change& a, const Change& b) {
    return std::tie(a.span.begin, a.span.end) < std::tie(b.span.begin, b.span.end);
  });
  Piece revised;
  std::size_t done = 0;
  for (const Change& change : changes_) {
    MBCC_ASSERT(change.span.begin >= done);
    revised += text_.substr(done, change.span.begin - done);
    revised += change.piece;
    done = change.span.end;
  }
  return revised + text_.substr(done);
}

}  // namespace mbcc::dialog
