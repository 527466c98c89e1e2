// Function calls.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "diagnostics/spelling.hpp"
#include "model/evaluator.hpp"
#include "model/names.hpp"

namespace mbcc::model {
namespace {

using graph::Operator;

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// Functions of two numbers that go on with the result and a third, a fourth, ...
constexpr std::array repeated = {Operator::Min, Operator::Max, Operator::Hypot};

/// Known to the language, but not built yet.
constexpr std::array<std::string_view, 5> later_functions = {"reaction", "multiplier", "effort", "rotation",
                                                             "quaternion"};

template <class Range, class Item>
bool contains(const Range& range, const Item& item) {
  return std::find(range.begin(), range.end(), item) != range.end();
}

}  // namespace

Value Evaluator::visit(const ast::Call& call, Span span, const Frame* frame) {
  if (call.function == "if") {
    return call_if(call, span, frame);
  }
  std::vector<Operand> arguments;
  bool known = true;
  for (const ast::Expression& argument : call.arguments) {
    arguments.push_back({evaluate(argument, frame), argument.span});
    known = known && !arguments.back().value.is_nothing();
  }
  if (!is_function(call.function)) {
    report_unknown(call, frame);
    return {};
  }
  if (contains(vector_functions, call.function)) {
    const std::size_t count = call.function == "norm" ? 1 : 2;
    return expect_arguments(call, count, count) && known ? call_vector_function(call, arguments, span) : Value();
  }
  const Operator op = *graph::find_function(call.function);
  const auto arity = static_cast<std::size_t>(graph::arity(op));
  const bool fits = expect_arguments(call, arity, contains(repeated, op) ? any_number : arity);
  return fits && known ? call_operator(op, call, arguments, span) : Value();
}

bool Evaluator::expect_arguments(const ast::Call& call, std::size_t least, std::size_t most) {
  const std::size_t given = call.arguments.size();
  if (least <= given && given <= most) {
    return true;
  }
  const std::string takes = least == most ? count_of(least, "argument") : fmt::format("{} or more arguments", least);
  context_.report.report(Finding::ArgumentCount, call.function_span, call.function, takes, given);
  return false;
}

Value Evaluator::call_vector_function(const ast::Call& call, const std::vector<Operand>& arguments, Span span) {
  if (call.function == "norm") {
    return algebra_.norm(arguments[0], span);
  }
  return call.function == "dot" ? algebra_.dot(arguments[0], arguments[1], span)
                                : algebra_.cross(arguments[0], arguments[1], span);
}

Value Evaluator::call_operator(Operator op, const ast::Call& call, const std::vector<Operand>& arguments, Span span) {
  const std::string what = fmt::format("an argument of `{}`", call.function);
  if (arguments.size() == 1) {
    return algebra_.apply(op, {arguments[0]}, what, span);
  }
  Operand result = arguments[0];
  for (std::size_t i = 1; i < arguments.size() && !result.value.is_nothing(); ++i) {
    result.value = algebra_.apply(op, {result, arguments[i]}, what, span);
  }
  return result.value;
}

Value Evaluator::call_if(const ast::Call& call, Span span, const Frame* frame) {
  const auto& comparison = std::get<ast::Comparison>(call.arguments[0].node);
  const bool exchanged = comparison.op == ast::ComparisonOperator::NotEqual;
  const ast::Expression& yes = call.arguments[exchanged ? 2 : 1];
  const ast::Expression& no = call.arguments[exchanged ? 1 : 2];
  const Value decision = condition(comparison, call.arguments[0].span, frame);
  if (decision.is_number()) {
    return evaluate(decision.is_zero() ? no : yes, frame);
  }
  const Operand if_true{evaluate(yes, frame), yes.span};
  const Operand if_false{evaluate(no, frame), no.span};
  return decision.is_nothing() ? Value() : algebra_.choose(decision[0], if_true, if_false, span);
}

/// The operator table has `<`, `<=` and `==`; `>` and `>=` exchange the sides, and `!=` is decided as `==`: whoever
/// asks exchanges the answers.
Value Evaluator::condition(const ast::Comparison& comparison, Span span, const Frame* frame) {
  const auto side = [&](std::size_t i) {
    return Operand{evaluate(comparison.operands[i], frame), comparison.operands[i].span};
  };
  const Operand left = side(0);
  const Operand right = side(1);
  const auto compare = [&](Operator op, const Operand& a, const Operand& b) {
    return algebra_.apply(op, {a, b}, "a side of a comparison", span);
  };
  switch (comparison.op) {
    case ast::ComparisonOperator::Less:
      return compare(Operator::Less, left, right);
    case ast::ComparisonOperator::LessEqual:
      return compare(Operator::LessEqual, left, right);
    case ast::ComparisonOperator::Greater:
      return compare(Operator::Less, right, left);
    case ast::ComparisonOperator::GreaterEqual:
      return compare(Operator::LessEqual, right, left);
    case ast::ComparisonOperator::Equal:
    case ast::ComparisonOperator::NotEqual:
      return compare(Operator::Equal, left, right);
  }
  return {};
}

void Evaluator::report_unknown(const ast::Call& call, const Frame* frame) {
  const Symbol* symbol = frame->scope->find(call.function);
  if (symbol != nullptr) {
    context_.report.report(Finding::NotAFunction, call.function_span, call.function, describe(symbol->kind));
  } else if (find_local(frame, call.function) != nullptr) {
    context_.report.report(Finding::NotAFunction, call.function_span, call.function, describe(SymbolKind::Let));
  } else if (find_index(frame, call.function) != nullptr) {
    context_.report.report(Finding::NotAFunction, call.function_span, call.function, "a loop index");
  } else if (const std::string_view reserved = reserved_as(call.function); !reserved.empty()) {
    context_.report.report(Finding::NotAFunction, call.function_span, call.function, reserved);
  } else if (contains(later_functions, call.function)) {
    context_.report.report(Finding::NotSupportedYet, call.function_span, call.function);
  } else {
    context_.report.report(Finding::UnknownFunction, call.function_span, call.function,
                           suggestion(call.function, function_names()));
  }
}

}  // namespace mbcc::model
