#include "model/evaluator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "diagnostics/assert.hpp"
#include "model/names.hpp"

namespace mbcc::model {
namespace {

/// Evaluation recurses; this many levels fit any stack that mbcc runs on, sanitizers included.
constexpr int most_levels = 1000;

/// Whole numbers beyond this are no counts, and their double would not be exact.
constexpr double largest_whole = 1e15;

}  // namespace

Value Evaluator::evaluate(const ast::Expression& expression, const Frame* frame) {
  if (context_.budget.is_exhausted()) {
    return {};
  }
  if (depth_ == most_levels) {
    context_.report.report(Finding::TooDeep, expression.span, most_levels);
    context_.budget.exhaust();
    return {};
  }
  ++depth_;
  const Value value =
      std::visit([&](const auto& node) { return visit(node, expression.span, frame); }, expression.node);
  --depth_;
  return value;
}

std::optional<double> Evaluator::structural(const ast::Expression& expression, const Frame* frame,
                                            std::string_view what) {
  const std::string_view outer = std::exchange(structural_, what);
  const Operand operand{evaluate(expression, frame), expression.span};
  structural_ = outer;
  if (!algebra_.expect_number(operand, what)) {
    return std::nullopt;
  }
  return operand.value[0].number;
}

std::optional<long> Evaluator::whole_number(const ast::Expression& expression, const Frame* frame,
                                            std::string_view what) {
  const std::optional<double> number = structural(expression, frame, what);
  if (!number) {
    return std::nullopt;
  }
  if (*number != std::floor(*number) || std::abs(*number) > largest_whole) {
    context_.report.report(Finding::NotWhole, expression.span, what, *number);
    return std::nullopt;
  }
  return static_cast<long>(*number);
}

std::optional<Indices> Evaluator::indices(const std::vector<ast::Expression>& expressions, const Frame* frame) {
  Indices indices;
  bool known = true;
  for (const ast::Expression& expression : expressions) {
    const std::optional<long> value = whole_number(expression, frame, "an index");
    known = known && value;
    indices.push_back(value.value_or(0));
  }
  return known ? std::optional(std::move(indices)) : std::nullopt;
}

/// A number that is out of range has been reported when it was read.
Value Evaluator::visit(const ast::Number& number, Span /*span*/, const Frame* /*frame*/) {
  return std::isfinite(number.value) ? Value(number.value) : Value();
}

Value Evaluator::visit(const ast::Unary& unary, Span span, const Frame* frame) {
  const ast::Expression& operand = unary.operand.front();
  Value value = evaluate(operand, frame);
  return unary.sign == '-' ? algebra_.negate({value, operand.span}, span) : value;
}

/// A long sum is a deep tree on its left side, so that side is walked, not recursed into.
Value Evaluator::visit(const ast::Binary& binary, Span span, const Frame* frame) {
  std::vector<std::pair<const ast::Binary*, Span>> chain = {{&binary, span}};
  const ast::Expression* left = &binary.operands[0];
  while (const auto* inner = std::get_if<ast::Binary>(&left->node)) {
    chain.emplace_back(inner, left->span);
    left = &inner->operands[0];
  }
  Operand result{evaluate(*left, frame), left->span};
  for (; !chain.empty(); chain.pop_back()) {
    const auto& [node, whole] = chain.back();
    const ast::Expression& right = node->operands[1];
    result = {combine(*node, result, {evaluate(right, frame), right.span}, whole), whole};
  }
  return result.value;
}

Value Evaluator::combine(const ast::Binary& binary, const Operand& left, const Operand& right, Span span) {
  if (left.value.is_nothing() || right.value.is_nothing() ||
      !context_.budget.allows_nodes(context_.arena.size(), span)) {
    return {};
  }
  switch (binary.op) {
    case ast::BinaryOperator::Add:
      return algebra_.add(left, right, binary.op_span, span);
    case ast::BinaryOperator::Subtract:
      return algebra_.subtract(left, right, binary.op_span, span);
    case ast::BinaryOperator::Multiply:
      return algebra_.multiply(left, right, binary.op_span, span);
    case ast::BinaryOperator::Divide:
      return algebra_.divide(left, right, span);
    case ast::BinaryOperator::Power:
      return algebra_.power(left, right, span);
  }
  return {};
}

/// The grammar has comparisons in `if` only, which looks at them itself.
Value Evaluator::visit(const ast::Comparison& /*comparison*/, Span /*span*/, const Frame* /*frame*/) {
  MBCC_ASSERT(false);
  return {};
}

Value Evaluator::visit(const ast::Vector& vector, Span span, const Frame* frame) {
  const std::size_t size = vector.components.size();
  if (size > axis_names.size()) {
    context_.report.report(Finding::VectorLength, span, size);
    return {};
  }
  Value result;
  bool known = true;
  for (const ast::Expression& component : vector.components) {
    const Operand operand{evaluate(component, frame), component.span};
    known = algebra_.expect_number(operand, "a component of a vector") && known;
    if (known) {
      result.append(operand.value[0]);
    }
  }
  return known ? result : Value();
}

Value Evaluator::visit(const ast::Parenthesised& parenthesised, Span /*span*/, const Frame* frame) {
  return evaluate(parenthesised.inner.front(), frame);
}

Value Evaluator::visit(const ast::Rate& rate, Span span, const Frame* frame) {
  return algebra_.rate(evaluate(rate.operand.front(), frame), span);
}

Value Evaluator::visit(const ast::Sum& sum, Span span, const Frame* frame) {
  const std::optional<long> first = whole_number(sum.bounds[0], frame, "a bound of `sum`");
  const std::optional<long> last = whole_number(sum.bounds[1], frame, "a bound of `sum`");
  if (!can_be_local(sum.index, sum.index_span, frame) || !first || !last) {
    return {};
  }
  if (*last < *first) {
    context_.report.report(Finding::EmptyLoop, join(sum.index_span, sum.bounds[1].span), sum.index, *first, *last);
  }
  const ast::Expression& body = sum.body.front();
  Value total = 0.0;
  bool known = true;
  for (long step = *first; step <= *last && context_.budget.spend_term(span); ++step) {
    const Frame inner{frame, sum.index, step, sum.index_span, {}, frame->scope};
    const Operand term{evaluate(body, &inner), body.span};
    known = known && !term.value.is_nothing();
    if (known) {
      total = algebra_.add({total, body.span}, term, body.span, span);
      known = !total.is_nothing();
    }
  }
  return known ? total : Value();
}

bool Evaluator::can_be_local(std::string_view name, Span span, const Frame* frame) {
  if (const std::string_view reserved = reserved_as(name); !reserved.empty()) {
    context_.report.report(Finding::ReservedName, span, name, reserved);
    return false;
  }
  const Symbol* symbol = frame->scope->find(name);
  const Frame* index = find_index(frame, name);
  const Definition* local = find_local(frame, name);
  if (symbol == nullptr && index == nullptr && local == nullptr) {
    return true;
  }
  const Span first = index != nullptr ? index->index_span : local != nullptr ? local->declarator->span : symbol->span;
  context_.report.report(Finding::Shadowing, span, name).note(first, "first declared here");
  return false;
}

}  // namespace mbcc::model
