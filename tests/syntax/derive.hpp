#pragma once
// Random sentences of a grammar.

#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "syntax/ebnf.hpp"

namespace mbcc::ebnf {

class Deriver {
 public:
  /// `tokens` are the productions that make one token each.
  Deriver(const Grammar& grammar, std::set<std::string> tokens, std::uint32_t seed);

  /// The tokens of one sentence. The deeper the derivation, the sooner it ends.
  std::vector<std::string> sentence(std::string_view production);

  /// The characters of one token.
  std::string token(std::string_view production);

  std::size_t below(std::size_t bound);  ///< uniform in [0, bound)
  template <class Values>
  const typename Values::value_type& any_of(const Values& values) {
    return values[below(values.size())];
  }

 private:
  void derive(const Node& node, std::size_t depth, std::vector<std::string>& sentence);
  void characters(const Node& node, std::string& text);
  const Node& chosen(const Node& choice, std::size_t depth);
  std::size_t height(const Node& node) const;
  void measure();

  const Grammar& grammar_;
  std::set<std::string> tokens_;
  std::map<std::string, std::size_t> heights_;  ///< of the lowest derivation of each production
  std::mt19937 random_;
};

}  // namespace mbcc::ebnf
