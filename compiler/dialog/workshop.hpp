#pragma once
// What a dialog has others do: the driver gives these functions, tests may give their own.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "model/system.hpp"

namespace mbcc::dialog {

/// What mbcc has to say about a text.
struct Findings {
  Sources sources;
  Diagnostics diagnostics;
  model::Integration times;  ///< as far as they are known
};

/// How far a text is looked into: names and rules of the language, or also the equations at the start.
enum class Depth { Language, Physics };

/// A coordinate or speed, where it is and where the nearest consistent start has it.
struct Moved {
  std::string name;
  double from = 0;
  double to = 0;
};

struct Workshop {
  /// `path` is where the text will be, for the places in diagnostics and for imports.
  std::function<Findings(const std::string& path, const std::string& text, Depth depth)> examine;
  /// Every coordinate and speed of the nearest start that satisfies the constraints; nothing if none is found.
  std::function<std::vector<Moved>(const std::string& path, const std::string& text)> assemble;

  std::function<bool(const std::string& path)> exists;
  std::function<std::optional<std::string>(const std::string& path)> read;
  std::function<bool(const std::string& path, const std::string& text)> write;
  std::function<void(const std::string& path)> remove;

  /// The commands of mbcc; they print what they have to say and return its exit code.
  std::function<int(const std::string& model, const std::string& program)> compile;
  std::function<int(const std::string& model)> check;
  std::function<int(const std::string& model)> run;
  std::function<int(const std::string& model, const std::string& figure)> plot;
};

}  // namespace mbcc::dialog
