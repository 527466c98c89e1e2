#pragma once
// What a run found, for programs (JSON) and for people.

#include <string>

#include "mbrt/model.hpp"
#include "options.hpp"
#include "run.hpp"

namespace mbrt {

std::string summary_json(const Description& model, const Outcome& outcome);

std::string summary_text(const Description& model, const Options& options, const Outcome& outcome);

}  // namespace mbrt
