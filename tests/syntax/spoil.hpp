#pragma once
// Sentences that are nearly right.

#include <string>
#include <string_view>
#include <vector>

#include "syntax/derive.hpp"

namespace mbcc::ebnf {

/// One token deleted, replaced or inserted. The new one is of the pool, or one that the sentence has elsewhere: those
/// make the near misses that random tokens seldom do. The sentence has a token at least.
inline void spoil(std::vector<std::string>& sentence, const std::vector<std::string>& pool, Deriver& deriver) {
  const std::string token = deriver.any_of(deriver.below(2) == 0 ? pool : sentence);
  const auto at = sentence.begin() + static_cast<std::ptrdiff_t>(deriver.below(sentence.size()));
  switch (deriver.below(3)) {
    case 0:
      sentence.erase(at);
      break;
    case 1:
      *at = token;
      break;
    default:
      sentence.insert(at, token);
  }
}

inline std::string joined(const std::vector<std::string>& tokens, std::string_view between) {
  std::string text;
  for (const std::string& token : tokens) {
    text += token;
    text += between;
  }
  return text;
}

}  // namespace mbcc::ebnf
