#include "model/resolve.hpp"

#include <map>

#include "model/compact.hpp"
#include "model/modules.hpp"
#include "model/system_builder.hpp"
#include "model/warnings.hpp"

namespace mbcc {
namespace {

using namespace model;

/// "pendulum" of "models/pendulum.mbd".
std::string stem(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::string base = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = base.find_last_of('.');
  return dot == std::string::npos || dot == 0 ? base : base.substr(0, dot);
}

/// An imported file's title is its own.
bool is_given_once(const ast::Statement& statement) {
  return std::holds_alternative<ast::Dimension>(statement.node) ||
         std::holds_alternative<ast::Gravity>(statement.node) ||
         std::holds_alternative<ast::Integrate>(statement.node) ||
         (std::holds_alternative<ast::System>(statement.node) && statement.span.file == 0);
}

void check_given_once(const std::vector<const ast::Statement*>& statements, Context& context) {
  std::map<std::size_t, const ast::Statement*> first;
  for (const ast::Statement* statement : statements) {
    if (!is_given_once(*statement)) {
      continue;
    }
    const auto [entry, is_new] = first.try_emplace(statement->node.index(), statement);
    if (!is_new) {
      context.report.report(Finding::GivenTwice, statement->keyword_span, context.sources.text(statement->keyword_span))
          .note(entry->second->keyword_span, "first given here");
    }
  }
}

void check_modules(const std::vector<const ast::Statement*>& statements, Context& context) {
  for (const ast::Statement* statement : statements) {
    if (const auto* module = std::get_if<ast::Module>(&statement->node)) {
      check_given_once(statements_of(*module), context);
    }
  }
}

System build(const Statements& statements, Context& context) {
  System system;
  system.name = stem(context.sources[0].name());
  Evaluator evaluator(context);
  const std::vector<Instance> instances = declare(statements, evaluator, context);
  if (context.dimension == 0 || context.budget.is_exhausted()) {
    return system;
  }
  system.dimension = context.dimension;
  SystemBuilder builder(evaluator, context, system);
  builder.find_motions(instances);
  builder.number_variables();
  builder.add_parameters();
  builder.add_particles();
  builder.add_variables();
  builder.order_starts();
  for (const Instance& instance : instances) {
    builder.add(instance);
  }
  for (Definition& definition : context.symbols.definitions) {
    evaluator.evaluate(definition);  // what nothing uses is checked all the same
  }
  if (!context.report.statements_are_lost() && !context.budget.is_exhausted()) {
    warn_of_unused(context);
  }
  return system;
}

}  // namespace

std::optional<model::System> resolve(const ast::ModelFile& file, const Sources& sources, const Importer& import,
                                     Diagnostics& diagnostics) {
  Context context(sources, diagnostics);
  Statements statements = gather(file, sources, import, context.report);
  warn_of_powers(statements.all, context);
  check_modules(statements.all, context);
  let_module_stand_alone(statements);
  check_given_once(statements.all, context);
  System system = build(statements, context);
  if (context.report.found_errors()) {
    return std::nullopt;
  }
  system.expressions = context.arena.take();
  compact(system);
  return system;
}

}  // namespace mbcc
