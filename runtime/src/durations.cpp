#include "durations.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mbrt {

std::string duration(double seconds) {
  if (seconds < 1) {
    return fmt::format("{:.3g} ms", 1e3 * seconds);
  }
  if (seconds < 60) {
    return fmt::format("{:.3g} s", seconds);
  }
  const double minutes = std::floor(seconds / 60);
  if (minutes < 60) {
    return fmt::format("{:.0f} min {:.0f} s", minutes, std::floor(seconds - 60 * minutes));
  }
  const double hours = std::floor(minutes / 60);
  return fmt::format("{:.0f} h {:.0f} min", hours, minutes - 60 * hours);
}

}  // namespace mbrt
