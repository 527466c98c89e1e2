#include "syntax/tree.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "diagnostics/assert.hpp"

namespace mbcc::tree {
namespace {

/// Height of the tallest tree of a list.
std::uint32_t tallest(const std::vector<ast::Expression>& trees) {
  std::uint32_t height = 0;
  for (const ast::Expression& tree : trees) {
    height = std::max(height, tree.height);
  }
  return height;
}

struct TallestChild {
  std::uint32_t operator()(const ast::Number&) const { return 0; }
  std::uint32_t operator()(const ast::Reference& node) const {
    std::uint32_t height = 0;
    for (const ast::Step& step : node.steps) {
      height = std::max(height, tallest(step.indices));
    }
    return height;
  }
  std::uint32_t operator()(const ast::Unary& node) const { return tallest(node.operand); }
  std::uint32_t operator()(const ast::Binary& node) const { return tallest(node.operands); }
  std::uint32_t operator()(const ast::Comparison& node) const { return tallest(node.operands); }
  std::uint32_t operator()(const ast::Call& node) const { return tallest(node.arguments); }
  std::uint32_t operator()(const ast::Vector& node) const { return tallest(node.components); }
  std::uint32_t operator()(const ast::Parenthesised& node) const { return tallest(node.inner); }
  std::uint32_t operator()(const ast::Rate& node) const { return tallest(node.operand); }
  std::uint32_t operator()(const ast::Sum& node) const { return std::max(tallest(node.bounds), tallest(node.body)); }
};

std::vector<ast::Expression> pair(ast::Expression left, ast::Expression right) {
  std::vector<ast::Expression> both;
  both.reserve(2);
  both.push_back(std::move(left));
  both.push_back(std::move(right));
  return both;
}

std::vector<ast::Expression> single(ast::Expression only) {
  std::vector<ast::Expression> one;
  one.push_back(std::move(only));
  return one;
}

ast::BinaryOperator binary_operator(TokenKind kind) {
  switch (kind) {
    case TokenKind::Plus:
      return ast::BinaryOperator::Add;
    case TokenKind::Minus:
      return ast::BinaryOperator::Subtract;
    case TokenKind::Star:
      return ast::BinaryOperator::Multiply;
    case TokenKind::Slash:
      return ast::BinaryOperator::Divide;
    default:
      MBCC_ASSERT(kind == TokenKind::Caret);
      return ast::BinaryOperator::Power;
  }
}

ast::ComparisonOperator comparison_operator(TokenKind kind) {
  switch (kind) {
    case TokenKind::Less:
      return ast::ComparisonOperator::Less;
    case TokenKind::LessEqual:
      return ast::ComparisonOperator::LessEqual;
    case TokenKind::Greater:
      return ast::ComparisonOperator::Greater;
    case TokenKind::GreaterEqual:
      return ast::ComparisonOperator::GreaterEqual;
    case TokenKind::EqualEqual:
      return ast::ComparisonOperator::Equal;
    default:
      MBCC_ASSERT(kind == TokenKind::NotEqual);
      return ast::ComparisonOperator::NotEqual;
  }
}

}  // namespace

ast::Expression expression(Span span, ast::ExpressionNode node) {
  const std::uint32_t height = 1 + std::visit(TallestChild{}, node);
  return {span, std::move(node), height};
}

ast::ExpressionNode parentheses(std::vector<ast::Expression> components) {
  if (components.size() == 1) {
    return ast::Parenthesised{std::move(components)};
  }
  return ast::Vector{std::move(components)};
}

ast::Expression binary(ast::Expression left, const Token& op, ast::Expression right) {
  const Span span = join(left.span, right.span);
  return expression(span, ast::Binary{binary_operator(op.kind), op.span, pair(std::move(left), std::move(right))});
}

ast::Expression comparison(ast::Expression left, const Token& op, ast::Expression right) {
  const Span span = join(left.span, right.span);
  return expression(span,
                    ast::Comparison{comparison_operator(op.kind), op.span, pair(std::move(left), std::move(right))});
}

ast::Expression with_signs(const std::vector<Token>& signs, ast::Expression operand) {
  for (auto sign = signs.rbegin(); sign != signs.rend(); ++sign) {
    const Span span = join(sign->span, operand.span);
    operand = expression(span, ast::Unary{sign->text.front(), single(std::move(operand))});
  }
  return operand;
}

ast::Expression rate(ast::Expression operand, const Token& prime) {
  const Span span = join(operand.span, prime.span);
  return expression(span, ast::Rate{single(std::move(operand))});
}

ast::VariableKind variable_kind(const Token& word) {
  return word.kind == TokenKind::Coordinate ? ast::VariableKind::Coordinate
         : word.kind == TokenKind::Speed    ? ast::VariableKind::Speed
                                            : ast::VariableKind::State;
}

ast::MotionKind motion_kind(const Token& word) {
  return word.kind == TokenKind::Kinematics ? ast::MotionKind::Kinematics : ast::MotionKind::Equation;
}

ast::EnergyKind energy_kind(const Token& word) {
  return word.kind == TokenKind::Kinetic ? ast::EnergyKind::Kinetic : ast::EnergyKind::Potential;
}

std::optional<ast::Number> number(const Token& token) {
  ast::Number number;
  number.is_natural = token.kind == TokenKind::Natural;
  const auto [end, error] = std::from_chars(token.text.data(), token.text.data() + token.text.size(), number.value);
  MBCC_ASSERT(error == std::errc::result_out_of_range || end == token.text.data() + token.text.size());
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::string unquoted(const Token& token) { return std::string(token.text.substr(1, token.text.size() - 2)); }

}  // namespace mbcc::tree
