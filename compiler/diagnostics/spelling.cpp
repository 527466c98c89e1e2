#include "diagnostics/spelling.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mbcc {
namespace {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edits(std::string_view from, std::string_view to) {
  std::vector<std::size_t> before(to.size() + 1), last(to.size() + 1), current(to.size() + 1);
  for (std::size_t j = 0; j <= to.size(); ++j) {
    last[j] = j;
  }
  for (std::size_t i = 1; i <= from.size(); ++i) {
    current[0] = i;
    for (std::size_t j = 1; j <= to.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (from[i - 1] == to[j - 1] ? 0 : 1);
      current[j] = std::min({last[j] + 1, current[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && from[i - 1] == to[j - 2] && from[i - 2] == to[j - 1]) {
        current[j] = std::min(current[j], before[j - 2] + 1);
      }
    }
    before.swap(last);
    last.swap(current);
  }
  return last[to.size()];
}

}  // namespace

std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::size_t longest_word = 64;  // a longer one is no slip of the pen, and comparing it would take long
  if (word.size() > longest_word) {
    return {};
  }
  std::size_t nearest = word.size() / 3 + 1;  // one slip in a short word, more in a long one
  std::string_view guess;
  for (const std::string_view candidate : candidates) {
    if (candidate.size() > longest_word) {
      continue;
    }
    const std::size_t distance = edits(word, candidate);
    // Replacing every letter of a short word is no slip either.
    if (distance < nearest + (guess.empty() ? 1 : 0) && distance < std::max(word.size(), candidate.size())) {
      nearest = distance;
      guess = candidate;
    }
  }
  return guess;
}

std::string suggestion(std::string_view word, const std::vector<std::string_view>& candidates) {
  const std::string_view guess = closest(word, candidates);
  return guess.empty() ? std::string() : fmt::format("; did you mean `{}`?", guess);
}

}  // namespace mbcc
