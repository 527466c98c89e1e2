#pragma once
// gnuplot, which draws for mbcc where it is installed.

#include <functional>
#include <string>

namespace mbcc {

/// What to install if there is no gnuplot; empty if there is one.
std::string obstacle_to_gnuplot();

/// Makes `path` what gnuplot draws by the script that `script_for` gives for a name of an output. The picture appears
/// whole or not at all. Returns what went wrong, or nothing.
std::string draw_with_gnuplot(const std::function<std::string(const std::string& output)>& script_for,
                              const std::string& path);

}  // namespace mbcc
