#include "model/declare.hpp"

#include <fmt/format.h>

#include <cmath>

#include "model/modules.hpp"

namespace mbcc::model {
namespace {

/// What may stand once in a model, outside of loops.
bool belongs_outside_loops(const ast::Statement& statement) {
  return std::holds_alternative<ast::System>(statement.node) ||
         std::holds_alternative<ast::Dimension>(statement.node) ||
         std::holds_alternative<ast::Constant>(statement.node) ||
         std::holds_alternative<ast::Gravity>(statement.node) || std::holds_alternative<ast::Import>(statement.node) ||
         std::holds_alternative<ast::Integrate>(statement.node) ||
         std::holds_alternative<ast::Module>(statement.node) || std::holds_alternative<ast::Port>(statement.node);
}

/// Of statements in loops.
bool is_local(const ast::Statement& statement) {
  const auto* let = std::get_if<ast::Let>(&statement.node);
  return let != nullptr && let->name.indices.empty();
}

/// Null for a port, which has none of its own.
const ast::Expression* expression_of(const ast::Statement& statement) {
  if (const auto* let = std::get_if<ast::Let>(&statement.node)) {
    return &let->value;
  }
  if (const auto* constant = std::get_if<ast::Constant>(&statement.node)) {
    return &constant->value;
  }
  if (const auto* point = std::get_if<ast::Point>(&statement.node)) {
    return &point->value;
  }
  const auto* parameter = std::get_if<ast::Parameter>(&statement.node);
  return parameter != nullptr ? &parameter->value : nullptr;
}

class Unrolling {
 public:
  Unrolling(Evaluator& evaluator, Context& context) : evaluator_(evaluator), context_(context) {}

  void declare_model(const Statements& statements) {
    Scope& scope = add_scope();
    scope.module = statements.alone;
    declare_statements(scope, statements.all);
  }

  std::vector<Instance> take() { return std::move(instances_); }

 private:
  Scope& add_scope() {
    Scope& scope = context_.symbols.scopes.emplace_back();
    scope.frame.scope = &scope;
    return scope;
  }

  void declare_statements(Scope& scope, const std::vector<const ast::Statement*>& statements) {
    declare_names(statements, scope, context_);
    if (scope.module != nullptr) {
      define_formals(scope);
    }
    declare_constants(scope, statements);
    if (!scope.is_part()) {
      find_dimension(scope, statements);
    }
    for (const ast::Statement* statement : statements) {
      add(*statement, &scope.frame);
    }
  }

  void define_formals(Scope& scope) {
    for (const ast::Formal& formal : scope.module->formals) {
      if (Definition* definition = enter_definition({SymbolKind::Formal, &formal.name}, &scope.frame)) {
        definition->expression = formal.value ? &*formal.value : nullptr;
        bind_formal(*definition, scope, context_);
      }
    }
  }

  void find_dimension(const Scope& scope, const std::vector<const ast::Statement*>& statements) {
    for (const ast::Statement* statement : statements) {
      const auto* dimension = std::get_if<ast::Dimension>(&statement->node);
      if (dimension == nullptr) {
        continue;
      }
      const std::optional<long> value = evaluator_.whole_number(dimension->value, &scope.frame, "the dimension");
      if (value && (*value < 1 || *value > 3)) {
        context_.report.report(Finding::DimensionRange, dimension->value.span, *value);
      }
      context_.dimension = value && 1 <= *value && *value <= 3 ? static_cast<int>(*value) : 0;
      return;
    }
  }

  /// Constants may be used in loop bounds and indices anywhere, so they come first: plain ones, then indexed ones.
  void declare_constants(Scope& scope, const std::vector<const ast::Statement*>& statements) {
    for (const bool indexed : {false, true}) {
      for (const ast::Statement* statement : statements) {
        const auto* constant = std::get_if<ast::Constant>(&statement->node);
        if (constant != nullptr && constant->name.indices.empty() != indexed) {
          define(*statement, &scope.frame);
        }
      }
    }
  }

  void add(const ast::Statement& statement, Frame* frame) {
    if (!context_.budget.spend_statement(statement.keyword_span)) {
      return;
    }
    if (const auto* loop = std::get_if<ast::For>(&statement.node)) {
      unroll(*loop, statement, frame);
    } else if (is_in_loop(frame) && belongs_outside_loops(statement)) {
      const bool is_constant = std::holds_alternative<ast::Constant>(statement.node);
      context_.report.report(Finding::NotInLoop, statement.keyword_span, context_.sources.text(statement.keyword_span),
                             is_constant ? ": use `let`" : "");
    } else if (const auto* port = std::get_if<ast::Port>(&statement.node); port && frame->scope->module == nullptr) {
      context_.report.report(Finding::OnlyInModule, statement.keyword_span);
      frame->scope->refused.insert(port->name.name);
    } else if (const auto* unsupported = std::get_if<ast::Unsupported>(&statement.node)) {
      context_.report.report(Finding::NotSupportedYet, statement.keyword_span, unsupported->keyword);
    } else {
      declare(statement, frame);
    }
  }

  void unroll(const ast::For& loop, const ast::Statement& statement, Frame* frame) {
    const std::optional<long> first = evaluator_.whole_number(loop.bounds[0], frame, "a loop bound");
    const std::optional<long> last = evaluator_.whole_number(loop.bounds[1], frame, "a loop bound");
    if (!evaluator_.can_be_local(loop.index, loop.index_span, frame) || !first || !last) {
      declare_incomplete(statement, *frame->scope, context_.symbols);
      return;
    }
    if (*last < *first) {
      context_.report.report(Finding::EmptyLoop, join(loop.index_span, loop.bounds[1].span), loop.index, *first, *last);
    }
    for (long value = *first; value <= *last && context_.budget.spend_statement(statement.keyword_span); ++value) {
      context_.symbols.frames.push_back({frame, loop.index, value, loop.index_span, {}, frame->scope});
      Frame& pass = context_.symbols.frames.back();
      for (const bool local : {true, false}) {  // so that loops inside see all local names that they must not hide
        for (const ast::Statement& inner : loop.body) {
          if (is_local(inner) == local) {
            add(inner, &pass);
          }
        }
      }
    }
  }

  void declare(const ast::Statement& statement, Frame* frame) {
    if (const auto* particle = std::get_if<ast::Particle>(&statement.node)) {
      declare_particle(*particle, statement.span, frame);
    } else if (const auto* part = std::get_if<ast::Part>(&statement.node)) {
      declare_part(*part, frame);
    } else if (const auto* variable = std::get_if<ast::Variable>(&statement.node)) {
      declare_variable(*variable, statement, frame);
    } else if (std::holds_alternative<ast::Constant>(statement.node)) {
      return;  // declared before all others
    } else if (declared_name(statement) && !std::holds_alternative<ast::Constraint>(statement.node)) {
      define(statement, frame);
    } else if (const auto* dimension = std::get_if<ast::Dimension>(&statement.node);
               dimension && frame->scope->is_part()) {
      check_dimension(*dimension, *frame->scope);
    } else {
      if (const std::optional<DeclaredName> label = declared_name(statement)) {
        enter(*label, 0, frame);
      }
      instances_.push_back({&statement, frame});
    }
  }

  void define(const ast::Statement& statement, Frame* frame) {
    const DeclaredName declared = *declared_name(statement);
    const ast::Declarator& declarator = *declared.declarator;
    const bool is_local = is_in_loop(frame) && declarator.indices.empty();
    if (is_local &&
        (declared.kind != SymbolKind::Let || !evaluator_.can_be_local(declarator.name, declarator.span, frame))) {
      return;
    }
    Definition* definition = is_local ? &new_definition(declared, {}, frame) : enter_definition(declared, frame);
    if (definition == nullptr) {
      return;
    }
    definition->expression = expression_of(statement);
    if (declared.kind == SymbolKind::Parameter) {
      definition->parameter = ParameterId{parameters_++};
    }
    if (is_local) {
      frame->locals.push_back(definition);
    } else if (is_port(statement) && !is_in_loop(frame)) {
      bind_port(*definition, *frame->scope, context_);
    }
  }

  Definition& new_definition(const DeclaredName& declared, const Indices& indices, const Frame* frame) {
    Definition& definition = context_.symbols.definitions.emplace_back();
    definition.kind = declared.kind;
    definition.declarator = declared.declarator;
    definition.frame = frame;
    definition.name = frame->scope->path_of(element_name(declared.declarator->name, indices));
    return definition;
  }

  /// Null if its name cannot be entered.
  Definition* enter_definition(const DeclaredName& declared, const Frame* frame) {
    const std::optional<Indices> indices = enter(declared, context_.symbols.definitions.size(), frame);
    return indices ? &new_definition(declared, *indices, frame) : nullptr;
  }

  void declare_part(const ast::Part& part, Frame* frame) {
    const std::optional<Indices> indices = enter({SymbolKind::Part, &part.name}, context_.symbols.scopes.size(), frame);
    if (!indices || !context_.budget.spend_part(part.name.span)) {
      return;
    }
    Scope& scope = add_scope();
    scope.name = frame->scope->path_of(element_name(part.name.name, *indices));
    scope.made_in = frame;
    scope.module = find_module(part, *frame->scope, context_);
    scope.is_lost = scope.module == nullptr;
    if (scope.is_lost) {
      return;
    }
    scope.arguments = arguments_of(part, scope, context_);
    scope.ports = ports_of(part, scope, context_);
    scope.trace = {part.name.span, fmt::format("in part `{}` of module `{}`", scope.name, part.module),
                   &frame->scope->trace};
    const Reporter::Within within(context_.report, scope.trace);
    declare_statements(scope, statements_of(*scope.module));
  }

  void check_dimension(const ast::Dimension& dimension, const Scope& scope) {
    const std::optional<long> value = evaluator_.whole_number(dimension.value, &scope.frame, "the dimension");
    if (value && context_.dimension != 0 && *value != context_.dimension) {
      context_.report.report(Finding::DimensionDiffers, dimension.value.span, scope.module->name.name, *value,
                             context_.dimension);
    }
  }

  void declare_particle(const ast::Particle& syntax, Span statement, Frame* frame) {
    const ast::Declarator& declarator = syntax.name;
    Particle particle;
    particle.position = context_.symbols.particles.size();
    particle.syntax = &syntax;
    particle.statement = statement;
    particle.frame = frame;
    const Frame* index = declarator.indices.empty() ? find_index(frame, declarator.name) : nullptr;
    const bool is_numbered = declarator.number || index != nullptr;
    if (is_numbered && frame->scope->module != nullptr) {
      context_.report.report(Finding::NotInModule, declarator.span, "a particle with a number", ": give it a name");
      return;
    }
    if (is_numbered) {
      const double number = declarator.number ? *declarator.number : static_cast<double>(index->value);
      if (!enter_number(number, particle, declarator)) {
        return;
      }
    } else {
      const std::optional<Indices> indices = enter({SymbolKind::Particle, &declarator}, particle.position, frame);
      if (!indices) {
        return;
      }
      particle.name = frame->scope->path_of(element_name(declarator.name, *indices));
    }
    context_.symbols.particles.push_back(particle);
  }

  void declare_variable(const ast::Variable& syntax, const ast::Statement& statement, Frame* frame) {
    const std::optional<Indices> indices = enter(*declared_name(statement), context_.symbols.variables.size(), frame);
    if (indices) {
      Variable& variable = context_.symbols.variables.emplace_back();
      variable.name = frame->scope->path_of(element_name(syntax.name.name, *indices));
      variable.syntax = &syntax;
      variable.statement = statement.span;
      variable.frame = frame;
    }
  }

  bool enter_number(double number, Particle& particle, const ast::Declarator& declarator) {
    if (number < 1 || number != std::floor(number) || number > static_cast<double>(Budget::most_statements)) {
      context_.report.report(Finding::ParticleNumber, declarator.span, number);
      return false;
    }
    particle.number = static_cast<long>(number);
    const Element element{particle.position, declarator.span};
    const auto [entry, is_new] = context_.symbols.numbered_particles.try_emplace(particle.number, element);
    if (!is_new) {
      context_.report.report(Finding::AlreadyDeclared, declarator.span, fmt::format("particle {}", particle.number))
          .note(entry->second.span, "first declared here");
    }
    return is_new;
  }

  /// The indices of the new element of a name; empty if it cannot be entered.
  std::optional<Indices> enter(const DeclaredName& declared, std::size_t position, const Frame* frame) {
    const ast::Declarator& declarator = *declared.declarator;
    Symbol* symbol = frame->scope->find(declarator.name);
    std::optional<Indices> indices = evaluator_.indices(declarator.indices, frame);
    if (symbol == nullptr || symbol->kind != declared.kind || symbol->index_count != declarator.indices.size()) {
      return std::nullopt;  // reported when the names were declared
    }
    if (!indices) {
      symbol->complete = false;
      return std::nullopt;
    }
    const auto [entry, is_new] = symbol->elements.try_emplace(*indices, Element{position, declarator.span});
    if (!is_new) {
      const bool by_loop = entry->second.span == declarator.span;
      context_.report.report(Finding::AlreadyDeclared, declarator.span, element_name(declarator.name, *indices))
          .note(entry->second.span, by_loop ? "first declared by an earlier pass of the loop" : "first declared here");
      return std::nullopt;
    }
    return indices;
  }

  Evaluator& evaluator_;
  Context& context_;
  std::vector<Instance> instances_;
  std::uint32_t parameters_ = 0;
};

void check_numbers(Context& context) {
  const Symbols& symbols = context.symbols;
  long expected = 1;
  for (const auto& [number, element] : symbols.numbered_particles) {
    if (number != expected) {
      if (symbols.numbers_complete && !context.report.statements_are_lost()) {
        context.report.report(Finding::ParticleGap, element.span, number, expected);
      }
      return;
    }
    ++expected;
  }
}

}  // namespace

std::vector<Instance> declare(const Statements& statements, Evaluator& evaluator, Context& context) {
  collect_modules(statements.all, context);
  Unrolling unrolling(evaluator, context);
  unrolling.declare_model(statements);
  check_numbers(context);
  return unrolling.take();
}

}  // namespace mbcc::model
