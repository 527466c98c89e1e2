#pragma once
// The syntax tree: one struct per production of grammar/model.ebnf, nothing checked beyond the grammar.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "source/source.hpp"

namespace mbcc::ast {

struct Expression;

struct Number {
  double value = 0;
  bool is_natural = false;  ///< digits only
};

/// One step of a path: `p[i, j]` in `p[i, j].position`.
struct Step {
  std::string name;
  Span span;
  std::vector<Expression> indices;
};

/// A dotted path: `x1`, `bob.x`, `p[i].position`, `upper.bob.x`.
struct Reference {
  std::vector<Step> steps;
};

struct Unary {
  char sign = '+';                  ///< '+' or '-'
  std::vector<Expression> operand;  ///< exactly one
};

enum class BinaryOperator { Add, Subtract, Multiply, Divide, Power };
struct Binary {
  BinaryOperator op = BinaryOperator::Add;
  Span op_span;
  std::vector<Expression> operands;  ///< exactly two: left, right
};

enum class ComparisonOperator { Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual };
/// Occurs only as the first argument of `if`; the grammar accepts it there alone.
struct Comparison {
  ComparisonOperator op = ComparisonOperator::Less;
  Span op_span;
  std::vector<Expression> operands;  ///< exactly two
};

struct Call {
  std::string function;
  Span function_span;
  std::vector<Expression> arguments;
};

/// `(a, b, c)`; two components or more.
struct Vector {
  std::vector<Expression> components;
};

struct Parenthesised {
  std::vector<Expression> inner;  ///< exactly one
};

/// Postfix prime: the total time derivative of its operand.
struct Rate {
  std::vector<Expression> operand;  ///< exactly one
};

/// `sum(j in first..last, body)`.
struct Sum {
  std::string index;
  Span index_span;
  std::vector<Expression> bounds;  ///< exactly two: first, last
  std::vector<Expression> body;    ///< exactly one
};

using ExpressionNode =
    std::variant<Number, Reference, Unary, Binary, Comparison, Call, Vector, Parenthesised, Rate, Sum>;

/// No expression that the parser made is higher than this, so that passes may walk the tree by recursion.
inline constexpr std::uint32_t max_height = 1000;

struct Expression {
  Span span;
  ExpressionNode node;
  std::uint32_t height = 1;  ///< nodes on the longest way down to a leaf, both included
};

/// What a statement declares: a name with indices inside loops, or a number (`particle 1`).
struct Declarator {
  std::string name;  ///< empty for a number
  std::optional<double> number;
  Span span;
  std::vector<Expression> indices;
};

/// `mass = 1` inside a particle or integrate block.
struct Field {
  std::string name;
  Span name_span;
  Expression value;
};

struct System {
  std::string name;
  Span name_span;
};
struct Dimension {
  Expression value;
};
struct Particle {
  Declarator name;
  std::vector<Field> fields;
};
enum class VariableKind { Coordinate, Speed, State };
struct Variable {
  VariableKind kind = VariableKind::Coordinate;
  Declarator name;
  std::vector<Field> fields;
};
enum class MotionKind { Kinematics, Equation };
/// `kinematics theta' = s/r`, `equation i' = -R*i/L`.
struct Motion {
  MotionKind kind = MotionKind::Kinematics;
  Expression target;  ///< a Reference: what moves, without its prime
  Expression value;
};
enum class EnergyKind { Kinetic, Potential };
struct Energy {
  EnergyKind kind = EnergyKind::Kinetic;
  Expression value;
};
/// `constraint label : left = right`; without `=` the left side is zero. More than two sides is the user's mistake.
struct Constraint {
  std::optional<Declarator> label;
  std::vector<Expression> sides;  ///< at least one
};
struct Let {
  Declarator name;
  Expression value;
};
struct Constant {
  Declarator name;
  Expression value;
};
struct Parameter {
  Declarator name;
  Expression value;
};
struct Output {
  Declarator name;
  Expression value;
};
struct ForceOn {
  Expression target;  ///< a Reference, or a Number for a numbered particle
  Expression value;
};
struct Gravity {
  Expression value;
};
struct Import {
  std::string path;
  Span path_span;
};
struct Integrate {
  std::vector<Field> fields;
};
/// A named position. Directly in a module it is a port, too, and the expression its default.
struct Point {
  Declarator name;
  Expression value;
};
/// A named position that whoever uses the module has to give.
struct Port {
  Declarator name;
};
/// `part upper = Pendulum(L = 0.5) { pivot = (0, 0, 0) }`: a system as one of another.
struct Part {
  Declarator name;
  std::string module;
  Span module_span;
  std::vector<Field> arguments;
  std::vector<Field> ports;
};
/// A parameter of a module.
struct Formal {
  Declarator name;
  std::optional<Expression> value;  ///< its default
};
struct Module;
struct For;

/// A statement of the language's later steps, recognised so that it is refused by name: `body`, `coordinate`, ...
struct Unsupported {
  std::string keyword;
};

using StatementNode =
    std::variant<System, Dimension, Particle, Variable, Motion, Energy, Constraint, Let, Constant, Parameter, Output,
                 ForceOn, Gravity, Import, Integrate, Module, Part, Point, Port, For, Unsupported>;
struct Statement;

struct Module {
  Declarator name;
  std::vector<Formal> formals;
  std::vector<Statement> body;
};

struct For {
  std::string index;
  Span index_span;
  std::vector<Expression> bounds;  ///< exactly two: first, last
  std::vector<Statement> body;
};

struct Statement {
  Span span;          ///< the whole statement
  Span keyword_span;  ///< its first word
  StatementNode node;
};

struct ModelFile {
  std::vector<Statement> statements;
};

}  // namespace mbcc::ast
