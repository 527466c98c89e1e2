#include <fmt/format.h>

#include <algorithm>

#include "driver/commands.hpp"
#include "driver/exit_codes.hpp"
#include "driver/files.hpp"
#include "driver/model_input.hpp"

namespace mbcc {

namespace {

using Lines = std::vector<std::string_view>;

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// One hunk in the unified format: everything from the first to the last line in which the two differ.
std::string difference(const Lines& old_lines, const Lines& new_lines) {
  constexpr std::ptrdiff_t context = 3;
  const auto [old_first, new_first] =
      std::mismatch(old_lines.begin(), old_lines.end(), new_lines.begin(), new_lines.end());
  const auto [old_last, new_last] = std::mismatch(old_lines.rbegin(), std::make_reverse_iterator(old_first),
                                                  new_lines.rbegin(), std::make_reverse_iterator(new_first));
  const auto before = std::min<std::ptrdiff_t>(context, old_first - old_lines.begin());
  const auto after = std::min<std::ptrdiff_t>(context, old_last - old_lines.rbegin());
  std::string text = fmt::format(
      "@@ -{},{} +{},{} @@\n", old_first - old_lines.begin() - before + 1, old_last.base() - old_first + before + after,
      new_first - new_lines.begin() - before + 1, new_last.base() - new_first + before + after);
  const auto append = [&text](char mark, auto begin, auto end) {
    for (auto line = begin; line != end; ++line) {
      text += fmt::format("{}{}\n", mark, *line);
    }
  };
  append(' ', old_first - before, old_first);
  append('-', old_first, old_last.base());
  append('+', new_first, new_last.base());
  append(' ', old_last.base(), old_last.base() + after);
  return text;
}

}  // namespace

int verify_command(const ModelArguments& arguments, const std::string& emitted) {
  const std::optional<std::string> old_text = read_file(emitted);
  if (!old_text) {
    return refuse(fmt::format("cannot read `{}`", emitted));
  }
  const std::optional<EmitOptions> options = options_of(*old_text);
  if (!options) {
    fmt::print(stderr, "mbcc: error: `{}` is no file that mbcc emitted: its header names no options\n", emitted);
    return exit_wrong_model;
  }
  ModelArguments as_emitted = arguments;
  as_emitted.strict |= options->strict;
  const std::optional<Compilation> compilation = compile_model(as_emitted, Stage::Program);
  if (!compilation) {
    return exit_wrong_usage;
  }
  if (!compilation->succeeded(arguments.werror)) {
    return exit_wrong_model;
  }
  const std::string text = emit(*compilation->program, *compilation->system, compilation->sources, *options);
  if (text == *old_text) {
    return exit_fine;
  }
  fmt::print("--- {}\n+++ what mbcc {} emits for {}\n{}", emitted, version, arguments.model,
             difference(lines_of(*old_text), lines_of(text)));
  return exit_wrong_model;
}

}  // namespace mbcc
