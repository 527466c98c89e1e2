#include "option_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "spelling.hpp"

namespace mbrt {

std::string guess_at(std::string_view name, std::span<const std::string_view> candidates) {
  const std::string_view guess = closest(name, candidates);
  return guess.empty() ? "" : fmt::format(", did you mean `{}`", guess);
}

double finite(std::string_view text, std::string_view flag) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) {
    throw UsageError{fmt::format("`{}` in `{}` is not a finite number", text, flag)};
  }
  return value;
}

double positive(std::string_view text, std::string_view flag) {
  const double value = finite(text, flag);
  if (value <= 0) {
    throw UsageError{fmt::format("`{} {}` is not positive", flag, text)};
  }
  return value;
}

long positive_integer(std::string_view text, std::string_view flag) {
  const double value = positive(text, flag);
  if (value != std::floor(value) || value > 1e9) {
    throw UsageError{fmt::format("`{}` in `{}` is not a number of times", text, flag)};
  }
  return static_cast<long>(value);
}

std::size_t index_of(std::string_view name, std::string_view kind, std::span<const std::string_view> names) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    throw UsageError{fmt::format("the model has no {} `{}`{}", kind, name, guess_at(name, names))};
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<Assignment> assignments(const std::vector<std::string>& texts, std::string_view flag, std::string_view kind,
                                    std::span<const std::string_view> names) {
  std::vector<Assignment> result;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) {
      throw UsageError{fmt::format("`{} {}` is not of the form NAME=VALUE", flag, text)};
    }
    const std::string_view name = std::string_view(text).substr(0, equals);
    const std::size_t index = index_of(name, kind, names);
    for (const Assignment& earlier : result) {
      if (earlier.index == index) {
        throw UsageError{fmt::format("`{}` gives `{}` two values", flag, name)};
      }
    }
    result.push_back({index, finite(std::string_view(text).substr(equals + 1), fmt::format("{} {}", flag, text))});
  }
  return result;
}

}  // namespace mbrt
