#pragma once
// Emitted classes, many in one program, built by the C++ compiler of this build and asked for rates at states.

#include <string>
#include <vector>

#include "run_program.hpp"

namespace mbcc::test {

/// States of one model, and the rates that it answered.
struct Question {
  std::vector<double> times;
  std::vector<std::vector<double>> states;
};
using Rates = std::vector<std::vector<double>>;

class EmittedModels {
 public:
  /// Takes the text of a header that mbcc emitted for the model file `name`.mbd; names are distinct C++ identifiers.
  void add(const std::string& name, const std::string& header);

  /// Compiles and links with `flags`; returns what the compiler printed and how it ended.
  Outcome build(const std::vector<std::string>& flags);

  /// One question per model, in the order of `add`.
  std::vector<Rates> ask(const std::vector<Question>& questions) const;

 private:
  ScratchDirectory directory_;
  std::vector<std::string> names_;
};

}  // namespace mbcc::test
