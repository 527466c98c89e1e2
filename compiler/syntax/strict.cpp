// The paper's own grammar of expressions, grammar/paper.ebnf, for `--strict`.

#include <algorithm>
#include <array>

#include "syntax/parser.hpp"

namespace mbcc {
namespace {

constexpr std::array<std::string_view, 15> functions = {"sin", "cos",  "tan",  "asin", "acos",  "atan",  "exp",  "ln",
                                                        "log", "sinh", "cosh", "tanh", "asinh", "acosh", "atanh"};

bool is_function(std::string_view name) {
  return std::find(functions.begin(), functions.end(), name) != functions.end();
}

/// `t`, or x, y, z with or without v and with an index from 1.
bool is_variable(std::string_view name) {
  if (name == "t") {
    return true;
  }
  name.remove_prefix(name.front() == 'v' ? 1 : 0);
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  return name.size() > 1 && name[0] >= 'x' && name[0] <= 'z' && name[1] != '0' &&
         std::all_of(name.begin() + 1, name.end(), is_digit);
}

bool is_sign(TokenKind kind) { return kind == TokenKind::Plus || kind == TokenKind::Minus; }

bool is_operator(TokenKind kind) {
  return is_sign(kind) || kind == TokenKind::Star || kind == TokenKind::Slash || kind == TokenKind::Caret;
}

/// Follows one expression through its tokens up to the first that the paper's grammar refuses.
class PaperExpression {
 public:
  PaperExpression(TokenBuffer::const_iterator first, TokenBuffer::const_iterator last, Diagnostics& diagnostics)
      : at_(first), last_(last), diagnostics_(diagnostics) {}

  void check() {
    if (expression() && at_ != last_) {
      refuse(Finding::StrictExpected, "an operator", shown());
    }
  }

 private:
  bool expression();
  bool atom();
  bool name();
  bool parenthesised();
  bool sees(TokenKind kind) const { return at_ != last_ && at_->kind == kind; }
  std::string shown() const { return fmt::format("`{}`", at_->text); }

  template <class... Arguments>
  bool refuse(Finding finding, const Arguments&... arguments) {
    diagnostics_.report(finding, at_->span, arguments...);
    return false;
  }

  TokenBuffer::const_iterator at_;
  TokenBuffer::const_iterator last_;
  Diagnostics& diagnostics_;
};

bool PaperExpression::expression() {
  if (!atom()) {
    return false;
  }
  while (at_ != last_ && is_operator(at_->kind)) {
    ++at_;
    if (!atom()) {
      return false;
    }
  }
  return true;
}

bool PaperExpression::atom() {
  if (sees(TokenKind::ParenLeft)) {
    return parenthesised();
  }
  if (sees(TokenKind::Name)) {
    return name();
  }
  if (is_sign(at_->kind)) {
    return refuse(Finding::StrictSign, at_->text);
  }
  if (sees(TokenKind::If) || sees(TokenKind::Sum)) {
    return refuse(Finding::StrictFunction, at_->text);
  }
  if (sees(TokenKind::Real) && at_->text.find('E') != std::string_view::npos) {
    return refuse(Finding::StrictNumber, at_->text);
  }
  ++at_;  // a number: nothing else begins an operand of a model's expression
  return true;
}

bool PaperExpression::name() {
  const bool is_call = std::next(at_) != last_ && std::next(at_)->kind == TokenKind::ParenLeft;
  const bool is_known = is_call ? is_function(at_->text) : is_variable(at_->text);
  if (!is_known) {
    return refuse(is_call ? Finding::StrictFunction : Finding::StrictName, at_->text);
  }
  ++at_;
  return !is_call || parenthesised();
}

bool PaperExpression::parenthesised() {
  ++at_;
  if (is_sign(at_->kind)) {
    ++at_;
  }
  if (!expression()) {
    return false;
  }
  if (!sees(TokenKind::ParenRight)) {
    return refuse(Finding::StrictExpected, "an operator or `)`", shown());
  }
  ++at_;
  return true;
}

/// Finds the forces and constraints of a model.
class StrictCheck {
 public:
  StrictCheck(const TokenBuffer& tokens, Diagnostics& diagnostics) : tokens_(tokens), diagnostics_(diagnostics) {}

  void statements(const std::vector<ast::Statement>& all) {
    for (const ast::Statement& statement : all) {
      std::visit(*this, statement.node);
    }
  }

  void operator()(const ast::Particle& particle) {
    for (const ast::Field& field : particle.fields) {
      if (field.name == "force") {
        force(field.value);
      }
    }
  }
  void operator()(const ast::ForceOn& statement) { force(statement.value); }
  void operator()(const ast::For& loop) { statements(loop.body); }
  void operator()(const ast::Module& module) { statements(module.body); }
  void operator()(const ast::Constraint& constraint) {
    if (constraint.sides.size() > 1) {
      diagnostics_.report(Finding::StrictEquation, first_token(constraint.sides[0].span.end)->span);
    }
    for (const ast::Expression& side : constraint.sides) {
      expression(side);
    }
  }
  template <class Other>
  void operator()(const Other&) {}

 private:
  /// The parentheses of a vector belong to the statement; its components are the expressions.
  void force(const ast::Expression& value) {
    if (const auto* vector = std::get_if<ast::Vector>(&value.node)) {
      for (const ast::Expression& component : vector->components) {
        expression(component);
      }
    } else {
      expression(value);
    }
  }

  void expression(const ast::Expression& whole) {
    PaperExpression(first_token(whole.span.begin), first_token(whole.span.end), diagnostics_).check();
  }

  TokenBuffer::const_iterator first_token(std::uint32_t from) const {
    const auto is_before = [](const Token& token, std::uint32_t place) { return token.span.begin < place; };
    return std::lower_bound(tokens_.begin(), tokens_.end(), from, is_before);
  }

  const TokenBuffer& tokens_;
  Diagnostics& diagnostics_;
};

}  // namespace

void check_strict(const ast::ModelFile& model, const Sources& sources, Diagnostics& diagnostics) {
  if (model.statements.empty()) {
    return;
  }
  Diagnostics reported_before;
  const TokenBuffer tokens = lex(sources, model.statements.front().span.file, reported_before);
  StrictCheck(tokens, diagnostics).statements(model.statements);
}

}  // namespace mbcc
