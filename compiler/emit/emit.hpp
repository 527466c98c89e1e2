#pragma once
// A Program as C++: the only layer, with templates/, that knows the language it writes.

#include <optional>
#include <string>
#include <string_view>

#include "model/system.hpp"
#include "program/program.hpp"
#include "source/source.hpp"

namespace mbcc {

/// Version of mbcc, and of the runtime interface (mbrt::interface_version) that emitted code needs.
inline constexpr std::string_view version = MBCC_VERSION;
inline constexpr int interface_version = 2;

struct EmitOptions {
  bool library = false;     ///< the class alone: no main, no streams
  bool strict = false;      ///< recorded in the header, so that the text can be verified
  std::string method = {};  ///< likewise, if it is not the model's own
};

/// The name of the file that `emit` makes of a model file, unless the user chooses another: `pendulum.cpp`.
std::string generated_file_name(std::string_view model_file, const EmitOptions& options);

/// The text of the generated file: a function of the model, the options and the version alone.
std::string emit(const program::Program& program, const model::System& system, const Sources& sources,
                 const EmitOptions& options);

/// The options that the header of an emitted text names; nothing if it is no text that mbcc emitted.
std::optional<EmitOptions> options_of(std::string_view emitted);

}  // namespace mbcc
