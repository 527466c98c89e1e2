#pragma once
// What a run found, as JSON.

#include <string>

#include "mbrt/model.hpp"
#include "run.hpp"

namespace mbrt {

std::string summary_json(const Description& model, const Options& options, const Outcome& outcome);

}  // namespace mbrt
