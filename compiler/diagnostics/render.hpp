#pragma once
// Diagnostics as text for people and as JSON for programs.

#include <string>

#include "diagnostics/diagnostic.hpp"

namespace mbcc {

enum class Colours { Off, On };

/// `file:line:column: error: message`, the source line, and a caret line under the span; notes likewise.
std::string render(const Diagnostic& diagnostic, const Sources& sources, Colours colours = Colours::Off);

/// All of them, in the order of their places in the sources.
std::string render(const Diagnostics& diagnostics, const Sources& sources, Colours colours = Colours::Off);

/// One array of objects {severity, name, file, line, column, end_line, end_column, message, notes}, in the same order.
/// Lines and columns count from 1, columns in bytes; the end is behind the last byte.
std::string render_json(const Diagnostics& diagnostics, const Sources& sources);

}  // namespace mbcc
