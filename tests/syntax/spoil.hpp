#pragma once
// Sentences that are nearly right.

#include <string>
#include <string_view>
#include <vector>

#include "syntax/derive.hpp"

namespace mbcc::ebnf {

/// One token deleted, replaced by one of the pool, or one of the pool inserted. The sentence has a token at least.
inline void spoil(std::vector<std::string>& sentence, const std::vector<std::string>& pool, Deriver& deriver) {
  const auto at = sentence.begin() + static_cast<std::ptrdiff_t>(deriver.below(sentence.size()));
  switch (deriver.below(3)) {
    case 0:
      sentence.erase(at);
      break;
    case 1:
      *at = deriver.any_of(pool);
      break;
    default:
      sentence.insert(at, deriver.any_of(pool));
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
