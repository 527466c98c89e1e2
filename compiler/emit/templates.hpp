#pragma once
// Templates: text with places for values. One construct, `@name@`; alone on a line it is a block, which takes that
// line's indentation. No loops, no conditions.

#include <map>
#include <string>
#include <string_view>

namespace mbcc::cpp {

/// The text of a file of templates/, embedded at build time.
std::string_view template_text(std::string_view name);

using Values = std::map<std::string, std::string, std::less<>>;

/// `text` with its places filled. The set of places and the set of values must be equal.
std::string fill(std::string_view text, const Values& values);

}  // namespace mbcc::cpp
