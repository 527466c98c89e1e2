#pragma once
// From the arguments of a command to a compilation whose diagnostics have been shown.

#include <optional>

#include "driver/commands.hpp"

namespace mbcc {

/// Nothing, with a message, if the model cannot be read.
std::optional<Compilation> compile_model(const ModelArguments& arguments, Stage until);

/// A line "mbcc: error: ..." on standard error; returns exit_wrong_usage.
int refuse(const std::string& message);

}  // namespace mbcc
