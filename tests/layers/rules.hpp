#pragma once
// The rules of the house that a compiler does not enforce, as functions of source files.

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc::layers {

/// What a file of the compiler breaks, one sentence each. `path` is relative to compiler/: "graph/dual.hpp".
///   order    a layer includes itself and what is to its left in architecture order
///   runtime  only the driver includes mbrt/: the rest knows the runtime by the text that it emits
///   text     C++ statements in string literals only in emit/
std::vector<std::string> broken_rules(std::string_view path, std::string_view text);

/// Text by path.
using Files = std::map<std::string, std::string>;

/// The source files, sorted, that include a header whose name starts with `prefix`, directly or through other files.
std::vector<std::string> sources_that_reach(const std::string& prefix, const Files& files);

}  // namespace mbcc::layers
