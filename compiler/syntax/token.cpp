#include "syntax/token.hpp"

#include <array>

namespace mbcc {
namespace {

constexpr std::array<std::string_view, token_kinds> descriptions = {
#define MBCC_TOKEN(name, described) described,
#include "syntax/tokens.def"
};

constexpr std::array<std::string_view, token_kinds> names = {
#define MBCC_TOKEN(name, described) #name,
#include "syntax/tokens.def"
};

}  // namespace

std::string_view describe(TokenKind kind) { return descriptions[static_cast<std::size_t>(kind)]; }
std::string_view name_of(TokenKind kind) { return names[static_cast<std::size_t>(kind)]; }

bool begins_statement(TokenKind kind) {
  return kind == TokenKind::LaterWord || (kind >= TokenKind::System && kind <= TokenKind::For);
}

bool is_reserved(TokenKind kind) { return begins_statement(kind) || kind == TokenKind::If || kind == TokenKind::Sum; }

bool is_comparison(TokenKind kind) {
  switch (kind) {
    case TokenKind::Less:
    case TokenKind::LessEqual:
    case TokenKind::Greater:
    case TokenKind::GreaterEqual:
    case TokenKind::EqualEqual:
    case TokenKind::NotEqual:
      return true;
    default:
      return false;
  }
}

}  // namespace mbcc
