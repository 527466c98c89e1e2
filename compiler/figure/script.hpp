#pragma once
// Figures as a script for gnuplot, data included.

#include <span>
#include <string>

#include "figure/panels.hpp"

namespace mbcc::figure {

enum class Format { Svg, Png, Pdf };

/// Results that are shown together have a dash pattern each; so many can be told apart.
inline constexpr std::size_t most_results = 5;

/// The script with which gnuplot 5.4 writes `output`: all figures on one page, in a pdf each on its own. The results,
/// at most `most_results`, have at least one column beside the time.
std::string gnuplot_script(std::span<const Table> results, Format format, const std::string& output);

}  // namespace mbcc::figure
