#pragma once
// Grammars in Wirth's notation, read from the documents in grammar/: the tests hold the parser to them.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc::ebnf {

enum class Kind { Literal, Range, Name, Sequence, Choice, Option, Repeat };

struct Node {
  Kind kind = Kind::Literal;
  std::string text;                   ///< of a Literal or Name
  unsigned char first = 0, last = 0;  ///< of a Range: the bytes from first to last
  std::vector<Node> children;
};

struct Grammar {
  std::map<std::string, Node, std::less<>> productions;
  std::string start;  ///< the first production

  const Node& operator[](std::string_view name) const { return productions.find(name)->second; }
};

/// Throws std::runtime_error that names the line where the notation is not followed.
Grammar read(std::string_view text);
Grammar read_file(const std::string& path);

std::set<std::string> undefined_names(const Grammar& grammar);
std::set<std::string> unreachable_names(const Grammar& grammar);
std::set<std::string> unproductive_names(const Grammar& grammar);  ///< from which no finite sentence comes

/// All literals of a production and of what it is made of.
std::set<std::string> literals_of(const Grammar& grammar, std::string_view production);

}  // namespace mbcc::ebnf
