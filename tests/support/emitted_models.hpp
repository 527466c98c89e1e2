#pragma once
// Emitted classes, many in one program, built by the C++ compiler of this build and asked for what they compute at
// states.

#include <string>
#include <vector>

#include "run_program.hpp"

namespace mbcc::test {

/// States of one model, and what it answered: everything_at each.
struct Question {
  std::vector<double> times;
  std::vector<std::vector<double>> states;
};
using Answers = std::vector<std::vector<double>>;

/// Whether repeated parts of a model became loops: whether any loop is over a number of iterations, not over a
/// container.
bool has_rolled_loops(const std::string& header);

class EmittedModels {
 public:
  /// Takes the text of a header that mbcc emitted for the model file `name`.mbd; names are distinct C++ identifiers.
  void add(const std::string& name, const std::string& header);

  /// Compiles and links with `flags`; returns what the compiler printed and how it ended.
  Outcome build(const std::vector<std::string>& flags);

  /// Has another compiler look at the same code, without building anything.
  Outcome check(const std::string& compiler, const std::vector<std::string>& flags);

  /// One question per model, in the order of `add`.
  std::vector<Answers> ask(const std::vector<Question>& questions) const;

 private:
  std::vector<std::string> write_units();

  ScratchDirectory directory_;
  std::vector<std::string> names_;
};

}  // namespace mbcc::test
