#pragma once
// The closed set of operators, from the table in operators.def.

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace mbcc::graph {

enum class Operator : std::uint8_t {
#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) name,
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) name,
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) name,
#include "graph/operators.def"
};

/// How the Taylor coefficients of an operator's value follow from those of its operands.
enum class Recurrence : std::uint8_t {
#define MBCC_RECURRENCE(name, rule) name,
#include "graph/recurrences.def"
};

struct OperatorRow {
  Operator op;
  std::string_view name;
  std::string_view spelling;  ///< in models
  std::string_view code;      ///< in C++
  Recurrence recurrence;
  int arity;
};

inline constexpr std::array operator_table = {
#define MBCC_OPERATOR1(name, spelling, code, function, recurrence, slope_a) \
  OperatorRow{Operator::name, #name, spelling, code, Recurrence::recurrence, 1},
#define MBCC_OPERATOR2(name, spelling, code, function, recurrence, slope_a, slope_b) \
  OperatorRow{Operator::name, #name, spelling, code, Recurrence::recurrence, 2},
#define MBCC_OPERATOR3(name, spelling, code, function, recurrence, slope_a, slope_b, slope_c) \
  OperatorRow{Operator::name, #name, spelling, code, Recurrence::recurrence, 3},
#include "graph/operators.def"
};

constexpr const OperatorRow& row(Operator op) { return operator_table[static_cast<std::size_t>(op)]; }
constexpr int arity(Operator op) { return row(op).arity; }

/// How tightly an operator binds in the text of models, loosest first; Nothing and Operand are what stands around one
/// and what needs no parentheses ever.
enum class Precedence : std::uint8_t { Nothing, Comparison, Sum, Product, Sign, Power, Operand };

constexpr Precedence precedence(Operator op) {
  switch (op) {
    case Operator::Less:
    case Operator::LessEqual:
    case Operator::Equal:
      return Precedence::Comparison;
    case Operator::Add:
    case Operator::Subtract:
      return Precedence::Sum;
    case Operator::Multiply:
    case Operator::Divide:
      return Precedence::Product;
    case Operator::Negate:
      return Precedence::Sign;
    case Operator::Power:
      return Precedence::Power;
    default:
      return Precedence::Operand;
  }
}

/// The next tighter one, so that `a - (b - c)` keeps its parentheses.
constexpr Precedence tighter(Precedence precedence) {
  return static_cast<Precedence>(static_cast<std::uint8_t>(precedence) + 1);
}

/// A function of the language by its spelling in models (`sin`, `atan2`, `if`); symbols are not functions.
constexpr std::optional<Operator> find_function(std::string_view spelling) {
  for (const OperatorRow& candidate : operator_table) {
    const char first = candidate.spelling.front();
    if (first >= 'a' && first <= 'z' && candidate.spelling == spelling) {
      return candidate.op;
    }
  }
  return std::nullopt;
}

}  // namespace mbcc::graph
