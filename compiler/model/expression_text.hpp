#pragma once
// Expressions of a System as text.

#include <string>
#include <vector>

#include "model/system.hpp"

namespace mbcc::model {

/// Minimal parentheses. What is used more than once, or lies very deep, is written once, under a name of its own
/// (`$1`): the text is never longer than the expressions.
class ExpressionText {
 public:
  explicit ExpressionText(const System& system);

  std::string operator()(ExpressionId id) const { return write(id, Binding::Nothing); }
  const std::vector<std::string>& named() const { return named_; }  ///< "$1 = x2 - x1", in order

 private:
  /// How strongly an operator holds its operands together, weakest first.
  using Binding = graph::Precedence;

  static Binding binding(const Expression& expression);
  std::string write(ExpressionId id, Binding around) const;
  std::string write(const Expression& expression) const;
  std::string write_application(const Expression& expression) const;

  const System& system_;
  std::vector<std::string> names_;  ///< of each expression; empty for what is written where it is used
  std::vector<std::string> named_;
};

}  // namespace mbcc::model
