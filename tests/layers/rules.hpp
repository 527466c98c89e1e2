#pragma once
// The rules of the house that a compiler does not enforce, as a function of one source file.

#include <string>
#include <string_view>
#include <vector>

namespace mbcc::layers {

/// What a file of the compiler breaks, one sentence each. `path` is relative to compiler/: "graph/dual.hpp".
///   order    a layer includes itself and what is to its left in architecture order
///   runtime  only the driver includes mbrt/: the rest knows the runtime by the text that it emits
///   parties  Boost.Spirit only in the parser's one source file, Eigen in no header
///   text     C++ statements in string literals only in emit/
std::vector<std::string> broken_rules(std::string_view path, std::string_view text);

}  // namespace mbcc::layers
