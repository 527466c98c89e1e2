#pragma once
// Whether a sentence belongs to a grammar: backtracking over all possibilities, remembered for each production. Slow,
// simple, and independent of the parser that it judges.

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "syntax/ebnf.hpp"

namespace mbcc::ebnf {

class Recogniser {
 public:
  /// Tries a Literal, Range or Name at a place: where it ends if it stands there, npos if it does not, nothing if the
  /// node is no terminal of the sentence.
  using Terminal = std::function<std::optional<std::size_t>(const Node&, std::size_t place)>;
  static constexpr std::size_t npos = static_cast<std::size_t>(-1);

  Recogniser(const Grammar& grammar, std::size_t size, Terminal terminal)
      : grammar_(grammar), size_(size), terminal_(std::move(terminal)) {}

  bool accepts(std::string_view production);

 private:
  using Places = std::set<std::size_t>;
  Places ends(const Node& node, std::size_t place);
  Places ends_of_name(const Node& node, std::size_t place);
  Places ends_of_sequence(const Node& node, std::size_t place);
  Places ends_of_choice(const Node& node, std::size_t place);
  Places ends_of_repeat(const Node& node, std::size_t place);

  const Grammar& grammar_;
  std::size_t size_;
  Terminal terminal_;
  std::map<std::pair<const Node*, std::size_t>, Places> known_;  ///< of whole productions
};

/// Whether a production makes exactly these characters.
bool makes(const Grammar& grammar, std::string_view production, std::string_view characters);

}  // namespace mbcc::ebnf
