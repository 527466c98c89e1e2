#pragma once
// The blocks of a page of documentation, for tests that hold them to the truth.

#include <sstream>
#include <string>
#include <vector>

#include "support/run_program.hpp"

namespace mbcc::test {

/// What stands between "```language name" and "```".
struct Block {
  std::string language;
  std::string name;  ///< mostly empty: the file that the block is
  std::string text;
};

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
  }
  return lines;
}

inline std::vector<Block> blocks_of(const std::filesystem::path& page) {
  std::vector<Block> blocks;
  bool inside = false;
  for (const std::string& line : lines_of(read_file(page))) {
    if (line.rfind("```", 0) == 0) {
      inside = !inside;
      if (inside) {
        Block& block = blocks.emplace_back();
        std::istringstream(line.substr(3)) >> block.language >> block.name;
      }
    } else if (inside) {
      blocks.back().text += line + "\n";
    }
  }
  return blocks;
}

/// The n-th block of a language, from 0; an empty one if there is none.
inline Block block_of(const std::filesystem::path& page, const std::string& language, int n) {
  for (const Block& block : blocks_of(page)) {
    if (block.language == language && n-- == 0) {
      return block;
    }
  }
  return {};
}

}  // namespace mbcc::test
