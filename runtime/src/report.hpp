#pragma once
// What a run found, for people: a few lines, the same for the same run but for the time that it took.

#include <string>

#include "mbrt/model.hpp"
#include "options.hpp"
#include "run.hpp"

namespace mbrt {

std::string report(const Description& model, const Options& options, const Outcome& outcome);

}  // namespace mbrt
