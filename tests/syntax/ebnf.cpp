#include "syntax/ebnf.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace mbcc::ebnf {
namespace {

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Grammar grammar() {
    Grammar grammar;
    for (skip_blanks(); at_ < text_.size(); skip_blanks()) {
      const std::string name = word();
      expect("=");
      if (!grammar.productions.emplace(name, choice()).second) {
        fail("`" + name + "` is defined twice");
      }
      expect(".");
      grammar.start = grammar.start.empty() ? name : grammar.start;
    }
    return grammar;
  }

 private:
  Node choice() {
    Node node{Kind::Choice, {}, 0, 0, {sequence()}};
    while (accept("|")) {
      node.children.push_back(sequence());
    }
    return node.children.size() == 1 ? node.children.front() : node;
  }

  Node sequence() {
    Node node{Kind::Sequence, {}, 0, 0, {item()}};
    while (begins_item()) {
      node.children.push_back(item());
    }
    return node.children.size() == 1 ? node.children.front() : node;
  }

  Node item() {
    if (accept("(")) {
      return closed(choice(), ")");
    }
    if (accept("[")) {
      return closed({Kind::Option, {}, 0, 0, {choice()}}, "]");
    }
    if (accept("{")) {
      return closed({Kind::Repeat, {}, 0, 0, {choice()}}, "}");
    }
    if (begins_literal()) {
      return literal();
    }
    return {Kind::Name, word(), 0, 0, {}};
  }

  Node closed(Node node, std::string_view closing) {
    expect(closing);
    return node;
  }

  Node literal() {
    const std::string first = quoted();
    if (!accept("..")) {
      return {Kind::Literal, first, 0, 0, {}};
    }
    return {Kind::Range, {}, byte(first), byte(quoted()), {}};
  }

  /// One character, or \x and two hexadecimal digits.
  unsigned char byte(const std::string& literal) {
    if (literal.size() == 4 && literal.substr(0, 2) == "\\x") {
      return static_cast<unsigned char>(std::stoi(literal.substr(2), nullptr, 16));
    }
    if (literal.size() != 1) {
      fail("a range is between single characters");
    }
    return static_cast<unsigned char>(literal[0]);
  }

  std::string quoted() {
    skip_blanks();
    const std::size_t begin = at_ + 1;
    const std::size_t end = begins_literal() ? text_.find(text_[at_], begin) : std::string_view::npos;
    if (end == std::string_view::npos) {
      fail("expected a literal");
    }
    at_ = end + 1;
    return std::string(text_.substr(begin, end - begin));
  }

  std::string word() {
    skip_blanks();
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_')) {
      ++at_;
    }
    if (begin == at_) {
      fail("expected a name");
    }
    return std::string(text_.substr(begin, at_ - begin));
  }

  bool begins_literal() const { return at_ < text_.size() && (text_[at_] == '"' || text_[at_] == '\''); }
  bool begins_item() {
    skip_blanks();
    return at_ < text_.size() && std::string_view(")]}|.").find(text_[at_]) == std::string_view::npos;
  }

  bool accept(std::string_view sign) {
    skip_blanks();
    const bool found = text_.substr(at_, sign.size()) == sign;
    at_ += found ? sign.size() : 0;
    return found;
  }
  void expect(std::string_view sign) {
    if (!accept(sign)) {
      fail("expected `" + std::string(sign) + "`");
    }
  }

  void skip_blanks() {
    while (at_ < text_.size()) {
      if (text_.substr(at_, 2) == "(*") {
        at_ = text_.find("*)", at_);
        at_ = at_ == std::string_view::npos ? text_.size() : at_ + 2;
      } else if (std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        ++at_;
      } else {
        return;
      }
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    const std::string_view before = text_.substr(0, at_);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    throw std::runtime_error("line " + std::to_string(line) + ": " + what);
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

void visit(const Node& node, const std::function<void(const Node&)>& see) {
  see(node);
  for (const Node& child : node.children) {
    visit(child, see);
  }
}

/// Visits a production and all that it is made of, each once.
std::set<std::string> visit_reachable(const Grammar& grammar, std::string_view from,
                                      const std::function<void(const Node&)>& see) {
  std::set<std::string> reached = {std::string(from)};
  std::vector<std::string> waiting = {std::string(from)};
  while (!waiting.empty()) {
    const std::string production = waiting.back();
    waiting.pop_back();
    visit(grammar[production], [&](const Node& node) {
      see(node);
      if (node.kind == Kind::Name && reached.insert(node.text).second) {
        waiting.push_back(node.text);
      }
    });
  }
  return reached;
}

bool is_productive(const Node& node, const std::set<std::string>& productive) {
  switch (node.kind) {
    case Kind::Name:
      return productive.count(node.text) != 0;
    case Kind::Sequence:
      return std::all_of(node.children.begin(), node.children.end(),
                         [&](const Node& child) { return is_productive(child, productive); });
    case Kind::Choice:
      return std::any_of(node.children.begin(), node.children.end(),
                         [&](const Node& child) { return is_productive(child, productive); });
    default:
      return true;
  }
}

}  // namespace

Grammar read(std::string_view text) { return Reader(text).grammar(); }

Grammar read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw std::runtime_error("cannot read " + path);
  }
  return read(std::string(std::istreambuf_iterator<char>(file), {}));
}

std::set<std::string> undefined_names(const Grammar& grammar) {
  std::set<std::string> undefined;
  for (const auto& [name, body] : grammar.productions) {
    visit(body, [&](const Node& node) {
      if (node.kind == Kind::Name && grammar.productions.count(node.text) == 0) {
        undefined.insert(node.text);
      }
    });
  }
  return undefined;
}

std::set<std::string> unreachable_names(const Grammar& grammar) {
  const std::set<std::string> reached = visit_reachable(grammar, grammar.start, [](const Node&) {});
  std::set<std::string> unreachable;
  for (const auto& [name, body] : grammar.productions) {
    if (reached.count(name) == 0) {
      unreachable.insert(name);
    }
  }
  return unreachable;
}

std::set<std::string> unproductive_names(const Grammar& grammar) {
  std::set<std::string> productive;
  for (bool grew = true; grew;) {
    grew = false;
    for (const auto& [name, body] : grammar.productions) {
      grew = (is_productive(body, productive) && productive.insert(name).second) || grew;
    }
  }
  std::set<std::string> unproductive;
  for (const auto& [name, body] : grammar.productions) {
    if (productive.count(name) == 0) {
      unproductive.insert(name);
    }
  }
  return unproductive;
}

std::set<std::string> literals_of(const Grammar& grammar, std::string_view production) {
  std::set<std::string> literals;
  visit_reachable(grammar, production, [&](const Node& node) {
    if (node.kind == Kind::Literal) {
      literals.insert(node.text);
    }
  });
  return literals;
}

}  // namespace mbcc::ebnf
