#pragma once
// Files of figures, whose form is told by the end of their names.

#include <string>
#include <vector>

#include "driver/subject.hpp"

namespace mbcc {

/// Why no figure could be written to `path`, whatever the result: what its name ends in, or a missing program. Empty if
/// nothing is in the way.
std::string obstacle_to_figure(const std::string& path);

/// Draws `results`, files as `--csv` records them, of `subject` into one figure; an old file stays as it was if that
/// fails. What is wrong is said on standard error. Returns the exit code.
int draw_figure(const std::vector<std::string>& results, const Subject& subject, const std::string& path);

}  // namespace mbcc
