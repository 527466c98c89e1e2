#include "syntax/recognise.hpp"

namespace mbcc::ebnf {

bool Recogniser::accepts(std::string_view production) {
  const Places reached = ends(grammar_[production], 0);
  return reached.count(size_) != 0;
}

/// All places where what the node makes can end if it begins at `place`.
Recogniser::Places Recogniser::ends(const Node& node, std::size_t place) {
  switch (node.kind) {
    case Kind::Literal:
    case Kind::Range:
    case Kind::Name:
      if (const std::optional<std::size_t> end = terminal_(node, place)) {
        return *end == npos ? Places{} : Places{*end};
      }
      return ends_of_name(node, place);
    case Kind::Sequence:
      return ends_of_sequence(node, place);
    case Kind::Choice:
      return ends_of_choice(node, place);
    case Kind::Option: {
      Places all = ends(node.children.front(), place);
      all.insert(place);
      return all;
    }
    case Kind::Repeat:
      return ends_of_repeat(node, place);
  }
  return {};
}

Recogniser::Places Recogniser::ends_of_name(const Node& node, std::size_t place) {
  const Node& body = grammar_[node.text];
  const std::pair key(&body, place);
  const auto known = known_.find(key);
  if (known != known_.end()) {
    return known->second;
  }
  return known_.emplace(key, ends(body, place)).first->second;
}

Recogniser::Places Recogniser::ends_of_sequence(const Node& node, std::size_t place) {
  Places reached = {place};
  for (const Node& child : node.children) {
    Places next;
    for (const std::size_t from : reached) {
      next.merge(ends(child, from));
    }
    reached = std::move(next);
  }
  return reached;
}

Recogniser::Places Recogniser::ends_of_choice(const Node& node, std::size_t place) {
  Places all;
  for (const Node& child : node.children) {
    all.merge(ends(child, place));
  }
  return all;
}

Recogniser::Places Recogniser::ends_of_repeat(const Node& node, std::size_t place) {
  Places all = {place};
  std::vector<std::size_t> waiting = {place};
  while (!waiting.empty()) {
    const std::size_t from = waiting.back();
    waiting.pop_back();
    for (const std::size_t end : ends(node.children.front(), from)) {
      if (all.insert(end).second) {
        waiting.push_back(end);
      }
    }
  }
  return all;
}

bool makes(const Grammar& grammar, std::string_view production, std::string_view characters) {
  const auto terminal = [characters](const Node& node, std::size_t place) -> std::optional<std::size_t> {
    if (node.kind == Kind::Name) {
      return std::nullopt;
    }
    if (node.kind == Kind::Literal) {
      const bool stands_here = characters.substr(place, node.text.size()) == node.text;
      return stands_here ? place + node.text.size() : Recogniser::npos;
    }
    const bool is_within = place < characters.size() && static_cast<unsigned char>(characters[place]) >= node.first &&
                           static_cast<unsigned char>(characters[place]) <= node.last;
    return is_within ? place + 1 : Recogniser::npos;
  };
  return Recogniser(grammar, characters.size(), terminal).accepts(production);
}

}  // namespace mbcc::ebnf
