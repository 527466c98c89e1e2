#pragma once
// Dialogs in a directory of their own, and the transcripts that they must make.

#include <catch2/catch.hpp>
#include <string>

#include "support/run_model.hpp"

namespace mbcc::test {

/// tests/dialog/transcripts has NAME.answers, what is typed, and NAME.transcript, what is then to be seen.
inline std::string transcript_file(const std::string& name) {
  return read_file(std::filesystem::path(MBCC_SOURCE_DIR) / "tests/dialog/transcripts" / name);
}

struct Desk {
  ScratchDirectory directory;

  /// mbcc with `input` on standard input, started in the directory.
  Outcome run(const std::string& arguments, const std::string& input) const {
    write_file(directory / ".input", input);
    const std::string in_directory = "cd " + quoted(directory / "") + " && ";
    return run_program("/bin/sh", {"-c", in_directory + quoted(MBCC_BINARY) + " " + arguments + " <.input"});
  }

  /// A dialog whose answers and transcript have that name.
  Outcome run_transcript(const std::string& name, const std::string& arguments = "") const {
    const Outcome outcome = run("dialog " + arguments, transcript_file(name + ".answers"));
    CHECK(outcome.output == transcript_file(name + ".transcript"));
    return outcome;
  }

  void write(const std::string& name, const std::string& text) const { write_file(directory / name, text); }
  [[nodiscard]] std::string read(const std::string& name) const { return read_file(directory / name); }
  [[nodiscard]] bool has(const std::string& name) const { return std::filesystem::exists(directory / name); }
};

}  // namespace mbcc::test
