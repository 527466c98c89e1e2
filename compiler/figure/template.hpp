#pragma once
// The text that is the same in every script for gnuplot.

#include <string_view>

namespace mbcc::figure {

/// The text of a file of templates/, embedded at build time.
std::string_view template_text(std::string_view name);

}  // namespace mbcc::figure
