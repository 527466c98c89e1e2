#pragma once
// What stands behind the flags of a command line: numbers, names and pairs of them. Mistakes are thrown.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "options.hpp"

namespace mbrt {

/// A mistake on the command line; `read_command_line` makes it exit code 2.
struct UsageError {
  std::string message;
};

/// ", did you mean `...`", or nothing.
std::string guess_at(std::string_view name, std::span<const std::string_view> candidates);

double finite(std::string_view text, std::string_view flag);
double positive(std::string_view text, std::string_view flag);
long positive_integer(std::string_view text, std::string_view flag);

/// Where `name` stands in `names`, which are those of a `kind`.
std::size_t index_of(std::string_view name, std::string_view kind, std::span<const std::string_view> names);

/// NAME=VALUE pairs as indices into `names`.
std::vector<Assignment> assignments(const std::vector<std::string>& texts, std::string_view flag, std::string_view kind,
                                    std::span<const std::string_view> names);

}  // namespace mbrt
