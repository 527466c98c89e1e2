#pragma once
// Answers line by line, from a script.

#include <cstdio>
#include <istream>

#include "dialog/reader.hpp"

namespace mbcc::dialog {

/// Prints each answer behind its question, as it would stand on a terminal; an empty line is the prefilled answer.
class Pipe {
 public:
  Pipe(std::istream& input, std::FILE* output) : input_(input), output_(output) {}

  Reply ask(const Question& question);
  void say(std::string_view lines);

 private:
  std::istream& input_;
  std::FILE* output_;
};

static_assert(Reader<Pipe>);

}  // namespace mbcc::dialog
