#include "syntax/recognise.hpp"

namespace mbcc::ebnf {

const Recogniser::Places& Recogniser::ends(const Node& node, std::size_t place) {
  const std::pair key(&node, place);
  const auto known = known_.find(key);
  if (known != known_.end()) {
    return known->second;
  }
  Places found = find_ends(node, place);
  return known_.emplace(key, std::move(found)).first->second;
}

Recogniser::Places Recogniser::find_ends(const Node& node, std::size_t place) {
  switch (node.kind) {
    case Kind::Literal:
    case Kind::Range:
    case Kind::Name: {
      const std::optional<std::size_t> end = terminal_(node, place);
      if (!end && node.kind == Kind::Name) {
        return ends(grammar_[node.text], place);
      }
      return end && *end != npos ? Places{*end} : Places{};
    }
    case Kind::Sequence:
      return find_sequence_ends(node, place);
    case Kind::Choice: {
      Places all;
      for (const Node& child : node.children) {
        const Places& some = ends(child, place);
        all.insert(some.begin(), some.end());
      }
      return all;
    }
    case Kind::Option: {
      Places all = ends(node.children.front(), place);
      all.insert(place);
      return all;
    }
    case Kind::Repeat:
      return find_repeat_ends(node, place);
  }
  return {};
}

Recogniser::Places Recogniser::find_sequence_ends(const Node& node, std::size_t place) {
  Places reached = {place};
  for (const Node& child : node.children) {
    Places next;
    for (const std::size_t from : reached) {
      const Places& some = ends(child, from);
      next.insert(some.begin(), some.end());
    }
    reached = std::move(next);
  }
  return reached;
}

Recogniser::Places Recogniser::find_repeat_ends(const Node& node, std::size_t place) {
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
