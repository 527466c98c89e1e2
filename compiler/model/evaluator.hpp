#pragma once
// Expressions of the language to values: looks up names, unrolls sums, folds what is known.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/algebra.hpp"
#include "model/names.hpp"

namespace mbcc::model {

/// What a structural expression is for, where the rest of the evaluation has to know it.
inline constexpr std::string_view default_of_parameter = "the default of a parameter";

/// Everything that is wrong with an expression is reported here; its value is then nothing.
class Evaluator {
 public:
  explicit Evaluator(Context& context) : context_(context), algebra_(context) {}

  Value evaluate(const ast::Expression& expression, const Frame* frame);

  /// Of numbers, constants and loop indices only. `what` says what for: "a loop bound must be known when compiling".
  std::optional<double> structural(const ast::Expression& expression, const Frame* frame, std::string_view what);
  std::optional<long> whole_number(const ast::Expression& expression, const Frame* frame, std::string_view what);
  /// Empty if one of them is wrong.
  std::optional<Indices> indices(const std::vector<ast::Expression>& expressions, const Frame* frame);

  Value value_of(Definition& definition, Span use);
  /// Without using it: a parameter's value is its default.
  Value evaluate(Definition& definition);

  /// Reports a name for a loop's or sum's index, or a local `let`, that means something else already.
  bool can_be_local(std::string_view name, Span span, const Frame* frame);

  /// What `force on` acts on; all empty if it has been reported.
  struct Target {
    const Particle* particle = nullptr;
    Definition* point = nullptr;
    const Variable* variable = nullptr;
  };
  Target target(const ast::Expression& target, const Frame* frame);

  /// The coordinate or state whose rate a statement tells; nullptr if it has been reported.
  Variable* moving(const ast::Motion& motion, const Frame* frame);

  Algebra& algebra() { return algebra_; }

 private:
  using Reference = ast::Reference;
  /// What the beginning of a path stands for; all empty if it has been reported.
  struct Base {
    Value value;
    Definition* definition = nullptr;
    const Particle* particle = nullptr;
    const Variable* variable = nullptr;
    const Scope* part = nullptr;
    std::size_t steps = 1;  ///< of the path
  };

  // evaluator.cpp
  Value visit(const ast::Number& number, Span span, const Frame* frame);
  Value visit(const ast::Unary& unary, Span span, const Frame* frame);
  Value visit(const ast::Binary& binary, Span span, const Frame* frame);
  Value visit(const ast::Comparison& comparison, Span span, const Frame* frame);
  Value visit(const ast::Vector& vector, Span span, const Frame* frame);
  Value visit(const ast::Parenthesised& parenthesised, Span span, const Frame* frame);
  Value visit(const ast::Rate& rate, Span span, const Frame* frame);
  Value visit(const ast::Sum& sum, Span span, const Frame* frame);
  Value combine(const ast::Binary& binary, const Operand& left, const Operand& right, Span span);

  // calls.cpp
  Value visit(const ast::Call& call, Span span, const Frame* frame);
  Value call_if(const ast::Call& call, Span span, const Frame* frame);
  Value condition(const ast::Comparison& comparison, Span span, const Frame* frame);
  Value call_vector_function(const ast::Call& call, const std::vector<Operand>& arguments, Span span);
  Value call_operator(graph::Operator op, const ast::Call& call, const std::vector<Operand>& arguments, Span span);
  bool expect_arguments(const ast::Call& call, std::size_t least, std::size_t most);
  void report_unknown(const ast::Call& call, const Frame* frame);

  // references.cpp
  Value visit(const Reference& reference, Span span, const Frame* frame);
  Base base(const Reference& reference, const Frame* frame);
  Base first(const ast::Step& step, const Frame* frame);
  Base element(const Symbol& symbol, const ast::Step& step, const Frame* frame);
  Value built_in(const ast::Step& step, const Frame* frame);
  Value numbered(const NumberedVariable& variable, const ast::Step& step, const Frame* frame);
  std::optional<Member> member_of(const std::string& owner, const ast::Step& step);
  Value member(const Particle& particle, const ast::Step& step, Span span);
  Value member(Definition& point, const ast::Step& step, Span span);
  Value component(const Value& value, const std::string& name, const ast::Step& step);
  Value motion(const Particle& particle, const Member& member, Span span);
  /// True, with a finding, where only what is known when compiling may stand.
  bool refuse_unless_structural(std::string_view name, std::string_view is, Span span);

  // misses.cpp: why a name was not found
  void report_unknown(const ast::Step& step, const Frame* frame);
  void report_unknown_element(const Scope& part, const ast::Step& step);
  void report_not_declared(const Symbol& symbol, const ast::Step& step, const Indices& indices, const Frame* frame);
  void report_not_a_value(const Scope& part, Span span);

  // targets.cpp
  Target numbered_target(const ast::Expression& target, const Frame* frame);

  // definitions.cpp
  template <class Evaluation>
  Value activate(Definition& definition, const Evaluation& evaluation);
  Value known(const ast::Expression& expression, const Frame* frame, std::string_view what);
  Value known_value_of(Definition& formal, Span use);
  Value position_of(const Definition& point);
  void report_cycle(const Definition& definition);

  Context& context_;
  Algebra algebra_;
  std::string_view structural_;      ///< what a structural expression is for; empty outside of one
  std::vector<Definition*> active_;  ///< definitions that are being evaluated, outermost first
  int depth_ = 0;
};

}  // namespace mbcc::model
