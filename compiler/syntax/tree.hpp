#pragma once
// Builds nodes of the syntax tree from tokens and smaller nodes.

#include <optional>
#include <vector>

#include "syntax/ast.hpp"
#include "syntax/token.hpp"

namespace mbcc::tree {

/// An expression of which the height is known because its children's is.
ast::Expression expression(Span span, ast::ExpressionNode node);

/// What stands in parentheses: `(a)` or, with several components, the vector `(a, b)`. Takes at least one.
ast::ExpressionNode parentheses(std::vector<ast::Expression> components);

ast::Expression binary(ast::Expression left, const Token& op, ast::Expression right);
ast::Expression comparison(ast::Expression left, const Token& op, ast::Expression right);

/// Signs apply from the operand outwards: the last one first.
ast::Expression with_signs(const std::vector<Token>& signs, ast::Expression operand);
ast::Expression rate(ast::Expression operand, const Token& prime);

ast::VariableKind variable_kind(const Token& word);
ast::MotionKind motion_kind(const Token& word);
ast::EnergyKind energy_kind(const Token& word);

/// Empty if the number is beyond the range of a double.
std::optional<ast::Number> number(const Token& token);

/// The text of a Text token without its quotes.
std::string unquoted(const Token& token);

}  // namespace mbcc::tree
