#pragma once
// Guesses what a misspelt word was meant to be.

#include <string>
#include <string_view>
#include <vector>

namespace mbcc {

/// The candidate nearest to `word` in single-letter edits, or an empty view if none is near enough to be a slip.
/// Of equally near ones the first wins. The view is the candidate's.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates);

/// The tail of a message: "; did you mean `particle`?", or nothing if no candidate is near.
std::string suggestion(std::string_view word, const std::vector<std::string_view>& candidates);

}  // namespace mbcc
