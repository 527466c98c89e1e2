#include "model/declare.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mbcc::model {
namespace {

/// What may stand once in a model, outside of loops.
bool belongs_outside_loops(const ast::Statement& statement) {
  return std::holds_alternative<ast::System>(statement.node) ||
         std::holds_alternative<ast::Dimension>(statement.node) ||
         std::holds_alternative<ast::Constant>(statement.node) ||
         std::holds_alternative<ast::Gravity>(statement.node) || std::holds_alternative<ast::Import>(statement.node) ||
         std::holds_alternative<ast::Integrate>(statement.node);
}

/// Of statements in loops.
bool is_local(const ast::Statement& statement) {
  const auto* let = std::get_if<ast::Let>(&statement.node);
  return let != nullptr && let->name.indices.empty();
}

const ast::Expression& expression_of(const ast::Statement& statement) {
  if (const auto* let = std::get_if<ast::Let>(&statement.node)) {
    return let->value;
  }
  if (const auto* constant = std::get_if<ast::Constant>(&statement.node)) {
    return constant->value;
  }
  return std::get<ast::Parameter>(statement.node).value;
}

class Unrolling {
 public:
  Unrolling(Evaluator& evaluator, Context& context) : evaluator_(evaluator), context_(context) {}

  /// Constants may be used in loop bounds and indices anywhere, so they come first: plain ones, then indexed ones.
  void declare_constants(const std::vector<const ast::Statement*>& statements) {
    for (const bool indexed : {false, true}) {
      for (const ast::Statement* statement : statements) {
        const auto* constant = std::get_if<ast::Constant>(&statement->node);
        if (constant != nullptr && constant->name.indices.empty() != indexed) {
          define(*statement, nullptr);
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
    } else if (frame != nullptr && belongs_outside_loops(statement)) {
      const bool is_constant = std::holds_alternative<ast::Constant>(statement.node);
      context_.report.report(Finding::NotInLoop, statement.keyword_span, context_.sources.text(statement.keyword_span),
                             is_constant ? ": use `let`" : "");
    } else if (const auto* unsupported = std::get_if<ast::Unsupported>(&statement.node)) {
      context_.report.report(Finding::NotSupportedYet, statement.keyword_span, unsupported->keyword);
    } else {
      declare(statement, frame);
    }
  }

  std::vector<Instance> take() { return std::move(instances_); }

 private:
  void unroll(const ast::For& loop, const ast::Statement& statement, Frame* frame) {
    const std::optional<long> first = evaluator_.whole_number(loop.bounds[0], frame, "a loop bound");
    const std::optional<long> last = evaluator_.whole_number(loop.bounds[1], frame, "a loop bound");
    if (!evaluator_.can_be_local(loop.index, loop.index_span, frame) || !first || !last) {
      declare_incomplete(statement, context_.symbols);
      return;
    }
    if (*last < *first) {
      context_.report.report(Finding::EmptyLoop, join(loop.index_span, loop.bounds[1].span), loop.index, *first, *last);
    }
    for (long value = *first; value <= *last && context_.budget.spend_statement(statement.keyword_span); ++value) {
      context_.symbols.frames.push_back({frame, loop.index, value, loop.index_span, {}});
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
    } else if (std::holds_alternative<ast::Let>(statement.node) ||
               std::holds_alternative<ast::Parameter>(statement.node)) {
      define(statement, frame);
    } else if (!std::holds_alternative<ast::Constant>(statement.node)) {
      if (const std::optional<DeclaredName> label = declared_name(statement)) {
        enter(*label, 0, frame);
      }
      instances_.push_back({&statement, frame});
    }
  }

  void define(const ast::Statement& statement, Frame* frame) {
    const DeclaredName declared = *declared_name(statement);
    const ast::Declarator& declarator = *declared.declarator;
    const bool is_local = frame != nullptr && declarator.indices.empty();
    std::optional<Indices> indices = Indices{};
    if (is_local) {
      if (declared.kind != SymbolKind::Let || !evaluator_.can_be_local(declarator.name, declarator.span, frame)) {
        return;
      }
    } else {
      indices = enter(declared, context_.symbols.definitions.size(), frame);
    }
    if (!indices) {
      return;
    }
    Definition& definition = context_.symbols.definitions.emplace_back();
    definition.kind = declared.kind;
    definition.declarator = &declarator;
    definition.expression = &expression_of(statement);
    definition.frame = frame;
    definition.name = element_name(declarator.name, *indices);
    if (declared.kind == SymbolKind::Parameter) {
      definition.parameter = ParameterId{parameters_++};
    }
    if (is_local) {
      frame->locals.push_back(&definition);
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
    if (declarator.number || index != nullptr) {
      const double number = declarator.number ? *declarator.number : static_cast<double>(index->value);
      if (!enter_number(number, particle, declarator)) {
        return;
      }
    } else {
      const std::optional<Indices> indices = enter({SymbolKind::Particle, &declarator}, particle.position, frame);
      if (!indices) {
        return;
      }
      particle.name = element_name(declarator.name, *indices);
    }
    context_.symbols.particles.push_back(particle);
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
    Symbol* symbol = context_.symbols.find(declarator.name);
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

void find_dimension(const std::vector<const ast::Statement*>& statements, Evaluator& evaluator, Context& context) {
  for (const ast::Statement* statement : statements) {
    const auto* dimension = std::get_if<ast::Dimension>(&statement->node);
    if (dimension == nullptr) {
      continue;
    }
    const std::optional<long> value = evaluator.whole_number(dimension->value, nullptr, "the dimension");
    if (value && (*value < 1 || *value > 3)) {
      context.report.report(Finding::DimensionRange, dimension->value.span, *value);
    }
    context.dimension = value && 1 <= *value && *value <= 3 ? static_cast<int>(*value) : 0;
    return;
  }
}

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

std::vector<Instance> declare(const std::vector<const ast::Statement*>& statements, Evaluator& evaluator,
                              Context& context) {
  declare_names(statements, context);
  Unrolling unrolling(evaluator, context);
  unrolling.declare_constants(statements);
  find_dimension(statements, evaluator, context);
  for (const ast::Statement* statement : statements) {
    unrolling.add(*statement, nullptr);
  }
  check_numbers(context);
  return unrolling.take();
}

}  // namespace mbcc::model
