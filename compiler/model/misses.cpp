// Why a name was not found, and what it may have been meant to be.

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "diagnostics/spelling.hpp"
#include "model/evaluator.hpp"

namespace mbcc::model {
namespace {

constexpr std::string_view blanks = " \t";
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

std::string_view take(std::string_view& text, std::string_view characters) {
  const std::size_t end = std::min(text.find_first_not_of(characters), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end);
  return taken;
}

/// Whether a statement in `text` looks like a declaration of `name`: a word and then the name.
bool looks_declared(std::string_view text, std::string_view name) {
  while (!text.empty()) {
    take(text, blanks);
    const std::string_view word = take(text, letters);
    take(text, blanks);
    if (!word.empty() && take(text, letters) == name) {
      return true;
    }
    text.remove_prefix(std::min(text.find_first_of("\n;{"), text.size()));
    text.remove_prefix(std::min<std::size_t>(1, text.size()));
  }
  return false;
}

/// Whether a statement that could not be read seems to declare `name`.
bool is_lost(const Context& context, const Scope& scope, std::string_view name) {
  if (context.report.names_are_lost() || scope.is_lost || scope.refused.count(name) != 0) {
    return true;
  }
  if (!context.report.statements_are_lost()) {
    return false;
  }
  for (std::uint32_t file = 0; file < context.sources.size(); ++file) {
    if (looks_declared(context.sources[file].text(), name)) {
      return true;
    }
  }
  return false;
}

bool is_lost_particle(const Context& context, const Scope& scope, const NumberedVariable& variable) {
  return !context.symbols.numbers_complete || is_lost(context, scope, fmt::to_string(variable.particle));
}

std::vector<std::string_view> names_of(const Scope& scope) {
  std::vector<std::string_view> names;
  for (const auto& entry : scope.table) {
    names.push_back(entry.first);
  }
  return names;
}

std::vector<std::string_view> visible_names(const Frame* frame) {
  std::vector<std::string_view> names = {"t", "pi"};
  const std::vector<std::string_view> declared = names_of(*frame->scope);
  for (; is_in_loop(frame); frame = frame->outer) {
    names.push_back(frame->index);
    for (const Definition* local : frame->locals) {
      names.push_back(local->declarator->name);
    }
  }
  names.insert(names.end(), declared.begin(), declared.end());
  return names;
}

/// What a name may have been meant to be, for the end of a message.
std::string guess(const Symbols& symbols, const std::string& name, const Frame* frame) {
  if (symbols.modules.count(name) != 0) {
    return fmt::format(": it is a module, and only a `part` of it can be used");
  }
  if (frame->scope->is_part() && symbols.scopes.front().find(name) != nullptr) {
    return ": the model has one, but a module sees its own names only, and may be given it by a parameter or a port";
  }
  return suggestion(name, visible_names(frame));
}

/// "`p` runs from 1 to 10", "`q` runs from 1 to 2 and from 1 to 3".
std::string describe_range(std::string_view name, const Symbol& symbol) {
  if (symbol.elements.empty()) {
    return fmt::format("the loop that declares `{}` is empty", name);
  }
  std::string range;
  for (std::size_t k = 0; k < symbol.index_count; ++k) {
    long first = std::numeric_limits<long>::max();
    long last = std::numeric_limits<long>::min();
    for (const auto& element : symbol.elements) {
      first = std::min(first, element.first[k]);
      last = std::max(last, element.first[k]);
    }
    range += fmt::format("{} {} to {}", k == 0 ? fmt::format("`{}` runs from", name) : " and from", first, last);
  }
  return range;
}

}  // namespace

void Evaluator::report_unknown(const ast::Step& step, const Frame* frame) {
  const std::string& name = step.name;
  const std::optional<NumberedVariable> variable = find_numbered_variable(name);
  const Scope& scope = *frame->scope;
  if (is_lost(context_, scope, name)) {
    return;
  }
  const auto particles = static_cast<long>(context_.symbols.numbered_particles.size());
  const bool is_foreign = scope.module != nullptr && variable;
  const std::string why = is_foreign ? "the particles of a module have names, not numbers"
                                     : why_no_variable(name, context_.dimension, particles);
  if (!step.indices.empty() && (!reserved_as(name).empty() || find_index(frame, name) || find_local(frame, name))) {
    context_.report.report(Finding::IndexCount, step.span, name, indices_taken(0), step.indices.size());
  } else if (is_function(name)) {
    context_.report.report(Finding::NotAValue, step.span, name, "a function", fmt::format(": write `{}(...)`", name));
  } else if (why.empty()) {
    context_.report.report(Finding::UnknownName, step.span, name, guess(context_.symbols, name, frame));
  } else if (!variable || !is_lost_particle(context_, scope, *variable)) {
    context_.report.report(Finding::NoSuchVariable, step.span, name, why);
  }
}

void Evaluator::report_unknown_element(const Scope& part, const ast::Step& step) {
  if (!is_lost(context_, part, step.name)) {
    context_.report.report(Finding::UnknownMember, step.span, part.name, step.name,
                           suggestion(step.name, names_of(part)));
  }
}

void Evaluator::report_not_a_value(const Scope& part, Span span) {
  const std::string example =
      part.table.empty() ? "" : fmt::format(": write `{}.{}` or the like", part.name, part.table.begin()->first);
  context_.report.report(Finding::NotAValue, span, part.name, "a part", example);
}

void Evaluator::report_not_declared(const Symbol& symbol, const ast::Step& step, const Indices& indices,
                                    const Frame* frame) {
  if (!symbol.complete || is_lost(context_, *frame->scope, step.name)) {
    return;
  }
  Diagnostic& finding = context_.report.report(Finding::NotDeclared, step.span, element_name(step.name, indices),
                                               describe_range(step.name, symbol));
  for (; is_in_loop(frame); frame = frame->outer) {
    finding.note(frame->index_span, fmt::format("here `{}` is {}", frame->index, frame->value));
  }
}

}  // namespace mbcc::model
