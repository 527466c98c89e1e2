#pragma once
// Guesses at what a mistyped name was meant to be.

#include <span>
#include <string>
#include <string_view>

namespace mbrt {

/// The candidate the fewest insertions, deletions and replacements away from `name`; empty if even that one is
/// more than a third of the name's length (at least 1) away.
std::string_view closest(std::string_view name, std::span<const std::string_view> candidates);

}  // namespace mbrt
