// Readable dumps of tokens and of the tree. Expressions are written operator first, so that one sees how they were
// read.

#include "syntax/parser.hpp"

namespace mbcc {
namespace {

std::string text_of(const ast::Expression& expression);

std::string list_of(const std::vector<ast::Expression>& expressions, std::string_view between) {
  std::string text;
  for (const ast::Expression& expression : expressions) {
    text += (text.empty() ? std::string_view() : between);
    text += text_of(expression);
  }
  return text;
}

std::string indices_of(const std::vector<ast::Expression>& indices) {
  return indices.empty() ? std::string() : fmt::format("[{}]", list_of(indices, ", "));
}

std::string_view sign_of(ast::BinaryOperator op) {
  switch (op) {
    case ast::BinaryOperator::Add:
      return "+";
    case ast::BinaryOperator::Subtract:
      return "-";
    case ast::BinaryOperator::Multiply:
      return "*";
    case ast::BinaryOperator::Divide:
      return "/";
    case ast::BinaryOperator::Power:
      break;
  }
  return "^";
}

std::string_view sign_of(ast::ComparisonOperator op) {
  switch (op) {
    case ast::ComparisonOperator::Less:
      return "<";
    case ast::ComparisonOperator::LessEqual:
      return "<=";
    case ast::ComparisonOperator::Greater:
      return ">";
    case ast::ComparisonOperator::GreaterEqual:
      return ">=";
    case ast::ComparisonOperator::Equal:
      return "==";
    case ast::ComparisonOperator::NotEqual:
      break;
  }
  return "!=";
}

struct ExpressionText {
  std::string operator()(const ast::Number& node) const { return fmt::format("{}", node.value); }
  std::string operator()(const ast::Reference& node) const {
    std::string path;
    for (const ast::Step& step : node.steps) {
      path += fmt::format("{}{}{}", path.empty() ? "" : ".", step.name, indices_of(step.indices));
    }
    return path;
  }
  std::string operator()(const ast::Unary& node) const {
    return fmt::format("({} {})", node.sign, list_of(node.operand, " "));
  }
  std::string operator()(const ast::Binary& node) const {
    return fmt::format("({} {})", sign_of(node.op), list_of(node.operands, " "));
  }
  std::string operator()(const ast::Comparison& node) const {
    return fmt::format("({} {})", sign_of(node.op), list_of(node.operands, " "));
  }
  std::string operator()(const ast::Call& node) const {
    return fmt::format("({} {})", node.function, list_of(node.arguments, " "));
  }
  std::string operator()(const ast::Vector& node) const {
    return fmt::format("(vector {})", list_of(node.components, " "));
  }
  std::string operator()(const ast::Parenthesised& node) const {
    return fmt::format("(group {})", list_of(node.inner, " "));
  }
  std::string operator()(const ast::Rate& node) const { return fmt::format("(rate {})", list_of(node.operand, " ")); }
  std::string operator()(const ast::Sum& node) const {
    return fmt::format("(sum {} {} {})", node.index, list_of(node.bounds, " .. "), list_of(node.body, " "));
  }
};

std::string text_of(const ast::Expression& expression) { return std::visit(ExpressionText{}, expression.node); }

std::string text_of(const ast::Declarator& declarator) {
  return declarator.number ? fmt::format("{}", *declarator.number) : declarator.name + indices_of(declarator.indices);
}

/// Statements, one a line, what they contain indented below them.
class StatementText {
 public:
  std::string statements(const std::vector<ast::Statement>& all) {
    std::string text;
    for (const ast::Statement& statement : all) {
      text += std::string(2 * depth_, ' ') + std::visit(*this, statement.node);
    }
    return text;
  }

  std::string operator()(const ast::System& node) { return fmt::format("system {}\n", node.name); }
  std::string operator()(const ast::Dimension& node) { return fmt::format("dimension {}\n", text_of(node.value)); }
  std::string operator()(const ast::Particle& node) {
    return fmt::format("particle {}\n", text_of(node.name)) + fields(node.fields);
  }
  std::string operator()(const ast::Variable& node) {
    const std::string_view word = node.kind == ast::VariableKind::Coordinate ? "coordinate"
                                  : node.kind == ast::VariableKind::Speed    ? "speed"
                                                                             : "state";
    return fmt::format("{} {}\n", word, text_of(node.name)) + fields(node.fields);
  }
  std::string operator()(const ast::Motion& node) {
    const std::string_view word = node.kind == ast::MotionKind::Kinematics ? "kinematics" : "equation";
    return fmt::format("{} {}' = {}\n", word, text_of(node.target), text_of(node.value));
  }
  std::string operator()(const ast::Energy& node) {
    const std::string_view word = node.kind == ast::EnergyKind::Kinetic ? "kinetic" : "potential";
    return fmt::format("{} {}\n", word, text_of(node.value));
  }
  std::string operator()(const ast::Constraint& node) {
    return fmt::format("constraint {}: {}\n", node.label ? text_of(*node.label) + " " : "", list_of(node.sides, " = "));
  }
  std::string operator()(const ast::Let& node) { return definition("let", node.name, node.value); }
  std::string operator()(const ast::Constant& node) { return definition("constant", node.name, node.value); }
  std::string operator()(const ast::Parameter& node) { return definition("parameter", node.name, node.value); }
  std::string operator()(const ast::Output& node) { return definition("output", node.name, node.value); }
  std::string operator()(const ast::ForceOn& node) {
    return fmt::format("force on {} = {}\n", text_of(node.target), text_of(node.value));
  }
  std::string operator()(const ast::Gravity& node) { return fmt::format("gravity {}\n", text_of(node.value)); }
  std::string operator()(const ast::Import& node) { return fmt::format("import \"{}\"\n", node.path); }
  std::string operator()(const ast::Integrate& node) { return "integrate\n" + fields(node.fields); }
  std::string operator()(const ast::Module& node) {
    std::string formals;
    for (const ast::Formal& formal : node.formals) {
      formals += fmt::format(" {}{}", text_of(formal.name), formal.value ? " = " + text_of(*formal.value) : "");
    }
    return fmt::format("module {}{}\n", text_of(node.name), formals) + body(node.body);
  }
  std::string operator()(const ast::Part& node) {
    std::string text = fmt::format("part {} = {}\n", text_of(node.name), node.module) + fields(node.arguments);
    return text + (node.ports.empty() ? "" : std::string(2 * depth_ + 2, ' ') + "ports\n") + fields(node.ports);
  }
  std::string operator()(const ast::Point& node) { return definition("point", node.name, node.value); }
  std::string operator()(const ast::Port& node) { return fmt::format("port {}\n", text_of(node.name)); }
  std::string operator()(const ast::For& node) {
    return fmt::format("for {} in {}\n", node.index, list_of(node.bounds, " .. ")) + body(node.body);
  }
  std::string operator()(const ast::Unsupported& node) { return fmt::format("unsupported {}\n", node.keyword); }

 private:
  std::string body(const std::vector<ast::Statement>& all) {
    ++depth_;
    std::string text = statements(all);
    --depth_;
    return text;
  }
  static std::string definition(std::string_view keyword, const ast::Declarator& name, const ast::Expression& value) {
    return fmt::format("{} {} = {}\n", keyword, text_of(name), text_of(value));
  }
  std::string fields(const std::vector<ast::Field>& all) const {
    std::string text;
    for (const ast::Field& field : all) {
      text += fmt::format("{}{} = {}\n", std::string(2 * depth_ + 2, ' '), field.name, text_of(field.value));
    }
    return text;
  }

  std::size_t depth_ = 0;
};

}  // namespace

std::string print(const TokenBuffer& tokens, const Sources& sources) {
  std::string text;
  for (const Token& token : tokens) {
    const Position position = sources.position(token.span);
    const std::string place = fmt::format("{}:{}", position.line, position.column);
    text += token.text.empty() ? fmt::format("{:<8}{}\n", place, name_of(token.kind))
                               : fmt::format("{:<8}{:<13} {}\n", place, name_of(token.kind), token.text);
  }
  return text;
}

std::string print(const ast::ModelFile& model) { return StatementText().statements(model.statements); }

}  // namespace mbcc
