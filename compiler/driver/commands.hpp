#pragma once
// The commands of mbcc. Each returns the exit code.

#include <string>
#include <vector>

#include "driver/compile.hpp"

namespace mbcc {

/// What every command that reads a model takes.
struct ModelArguments {
  std::string model;  ///< path; `-` is standard input
  bool strict = false;
  bool werror = false;
  bool json_diagnostics = false;
  bool assembles = false;   ///< as in CompileOptions
  std::string method = {};  ///< of integration, instead of the model's own; may be empty
};

/// Writes the emitted file, or leaves an old one as it was. A depfile for make and ninja is written if asked for.
int compile_command(const ModelArguments& arguments, const std::string& output, bool library,
                    const std::string& depfile);

/// Builds and becomes the simulation, with `flags` as its arguments; interprets it where there is no C++ compiler. With
/// a name of a figure in `plot` it draws what the simulation has recorded.
int run_command(const ModelArguments& arguments, const std::string& cxx_flags, const std::vector<std::string>& flags,
                const std::string& plot);

/// Prints the structure of the model.
int check_command(const ModelArguments& arguments);

/// Compares an emitted file with what this mbcc emits for the model.
int verify_command(const ModelArguments& arguments, const std::string& emitted);

/// Asks for a model: for a new one, or starting from `model`. It goes to `output`, or NAME.mbd beside `model`.
int dialog_command(const std::string& model, const std::string& output, bool force);

/// Prints one representation of the model.
int dump_command(const ModelArguments& arguments, const std::string& stage, bool partials);

}  // namespace mbcc
