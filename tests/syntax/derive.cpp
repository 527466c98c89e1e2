#include "syntax/derive.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace mbcc::ebnf {
namespace {

constexpr std::size_t unknown = std::numeric_limits<std::size_t>::max() / 2;
constexpr std::size_t free_depth = 24;  // productions inside one another that are chosen freely

}  // namespace

Deriver::Deriver(const Grammar& grammar, std::set<std::string> tokens, std::uint32_t seed)
    : grammar_(grammar), tokens_(std::move(tokens)), random_(seed) {
  measure();
}

std::size_t Deriver::below(std::size_t bound) { return random_() % bound; }

std::vector<std::string> Deriver::sentence(std::string_view production) {
  std::vector<std::string> sentence;
  derive(grammar_[production], 0, sentence);
  return sentence;
}

std::string Deriver::token(std::string_view production) {
  std::string text;
  characters(grammar_[production], text);
  return text;
}

void Deriver::derive(const Node& node, std::size_t depth, std::vector<std::string>& sentence) {
  const std::size_t patience = 2 + depth / 6;  // one in so many options is taken
  switch (node.kind) {
    case Kind::Literal:
      sentence.push_back(node.text);
      break;
    case Kind::Name:
      if (tokens_.count(node.text) != 0) {
        sentence.push_back(token(node.text));
      } else {
        derive(grammar_[node.text], depth + 1, sentence);
      }
      break;
    case Kind::Sequence:
      for (const Node& child : node.children) {
        derive(child, depth, sentence);
      }
      break;
    case Kind::Choice:
      derive(chosen(node, depth), depth, sentence);
      break;
    case Kind::Option:
    case Kind::Repeat:
      while (depth < free_depth && below(patience) == 0) {
        derive(node.children.front(), depth, sentence);
        if (node.kind == Kind::Option) {
          break;
        }
      }
      break;
    case Kind::Range:
      break;  // only inside tokens
  }
}

/// Freely while the derivation is shallow, then the lowest.
const Node& Deriver::chosen(const Node& choice, std::size_t depth) {
  if (depth < free_depth) {
    return any_of(choice.children);
  }
  return *std::min_element(choice.children.begin(), choice.children.end(),
                           [this](const Node& a, const Node& b) { return height(a) < height(b); });
}

void Deriver::characters(const Node& node, std::string& text) {
  switch (node.kind) {
    case Kind::Literal:
      text += node.text;
      break;
    case Kind::Range:
      text += static_cast<char>(node.first + below(1U + node.last - node.first));
      break;
    case Kind::Name:
      characters(grammar_[node.text], text);
      break;
    case Kind::Sequence:
      for (const Node& child : node.children) {
        characters(child, text);
      }
      break;
    case Kind::Choice:
      characters(any_of(node.children), text);
      break;
    case Kind::Option:
      if (below(2) == 0) {
        characters(node.children.front(), text);
      }
      break;
    case Kind::Repeat:
      while (below(2) == 0) {
        characters(node.children.front(), text);
      }
      break;
  }
}

std::size_t Deriver::height(const Node& node) const {
  std::size_t result = node.kind == Kind::Choice ? unknown : 0;
  switch (node.kind) {
    case Kind::Name:
      return tokens_.count(node.text) != 0 ? 1 : 1 + heights_.at(node.text);
    case Kind::Sequence:
      for (const Node& child : node.children) {
        result = std::max(result, height(child));
      }
      return result;
    case Kind::Choice:
      for (const Node& child : node.children) {
        result = std::min(result, height(child));
      }
      return result;
    default:
      return 0;
  }
}

void Deriver::measure() {
  for (const auto& [name, body] : grammar_.productions) {
    heights_[name] = unknown;
  }
  for (bool improved = true; improved;) {
    improved = false;
    for (const auto& [name, body] : grammar_.productions) {
      const std::size_t measured = std::min(height(body), unknown);
      improved = improved || measured < heights_[name];
      heights_[name] = measured;
    }
  }
}

}  // namespace mbcc::ebnf
