#pragma once
// The names of a model: a table for the model itself, over all its files, and one for each of its parts.
//
// A name stands for one kind of thing and has the same number of indices everywhere. Names are visible in the whole
// scope, in any order, indexed ones declared in loops too; a `let` without index inside a loop is visible in one pass
// of that loop only. Outputs are columns, not names: no expression refers to them.

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/reporter.hpp"
#include "model/value.hpp"
#include "syntax/ast.hpp"

namespace mbcc::model {

using Indices = std::vector<long>;

struct IndicesHash {
  std::size_t operator()(const Indices& indices) const;
};

struct Definition;
struct Scope;

/// One pass of a loop or sum: the value of its index, and the definitions that are local to it. The outermost frame of
/// a scope is no loop.
struct Frame {
  const Frame* outer = nullptr;  ///< null of a scope's own
  std::string_view index;
  long value = 0;
  Span index_span;
  std::vector<Definition*> locals;
  Scope* scope = nullptr;
};
inline bool is_in_loop(const Frame* frame) { return frame->outer != nullptr; }

enum class SymbolKind {
  Constant,
  Parameter,
  Let,
  Formal,
  Point,
  Port,
  Particle,
  Coordinate,
  Speed,
  State,
  Constraint,
  Part
};
std::string_view describe(SymbolKind kind);  ///< "a parameter"
SymbolKind kind_of(ast::VariableKind kind);

/// Whether what it stands for is a position, with members like those of a particle.
inline bool is_position(SymbolKind kind) { return kind == SymbolKind::Point || kind == SymbolKind::Port; }

/// Whether it stands for a coordinate, speed or state that is declared as such.
inline bool is_variable(SymbolKind kind) {
  return kind == SymbolKind::Coordinate || kind == SymbolKind::Speed || kind == SymbolKind::State;
}

/// A name for an expression, evaluated when first used. What a part is given is an expression of the system around it.
struct Definition {
  SymbolKind kind = SymbolKind::Let;
  const ast::Declarator* declarator = nullptr;
  const ast::Expression* expression = nullptr;  ///< null if none is given, which has been reported
  const Frame* frame = nullptr;                 ///< in which the expression stands
  std::string name;                             ///< with its part and indices
  ParameterId parameter{};                      ///< of a parameter
  enum class State { Waiting, Active, Done } state = State::Waiting;
  bool is_known = false;  ///< of a parameter of a module: its value is known when compiling
  Value value;
};

struct Particle {
  std::string name;          ///< `bob`, `p[3]`, `upper.bob`; empty for numbered ones
  long number = 0;           ///< from 1; 0 for named ones
  std::size_t position = 0;  ///< in order of declaration, from 0
  const ast::Particle* syntax = nullptr;
  Span statement;
  const Frame* frame = nullptr;
};
std::string describe(const Particle& particle);  ///< "particle 1", "`bob`"

/// A `coordinate`, `speed` or `state`.
struct Variable {
  std::string name;  ///< `theta`, `q[3]`, `upper.theta`
  const ast::Variable* syntax = nullptr;
  Span statement;
  const Frame* frame = nullptr;
  const ast::Motion* motion = nullptr;  ///< its `kinematics` or `equation`, if it has one
  const Frame* motion_frame = nullptr;
  std::uint32_t coordinate = 0;  ///< index, unless it is a speed
  std::uint32_t speed = 0;       ///< index of a speed, or of a coordinate's rate without kinematics

  bool is_speed() const { return syntax->kind == ast::VariableKind::Speed; }
  bool is_state() const { return syntax->kind == ast::VariableKind::State; }
  /// Whether a speed of the System belongs to it.
  bool has_speed() const { return is_speed() || (!is_state() && motion == nullptr); }
};

struct Element {
  std::size_t position = 0;  ///< among the definitions, particles, variables, scopes
  Span span;
};

struct Symbol {
  SymbolKind kind = SymbolKind::Let;
  Span span;  ///< of the first declaration
  std::size_t index_count = 0;
  bool complete = true;  ///< false if a loop that declares elements of it could not be unrolled
  std::unordered_map<Indices, Element, IndicesHash> elements;
};

/// A system with names of its own: the model, or one of its parts.
struct Scope {
  const ast::Module* module = nullptr;  ///< whose statements it consists of; null for a model of plain statements
  const Frame* made_in = nullptr;       ///< where the part is declared; null for the model
  std::string name;                     ///< "upper", "link[3].hinge"; empty for the model
  std::map<std::string, Symbol, std::less<>> table;
  std::set<std::string, std::less<>> refused;  ///< declared, but not as it should be; using them is no new mistake
  bool is_lost = false;                        ///< what it has is not known, which has been reported
  Frame frame;                                 ///< outside of its loops
  std::map<std::string_view, const ast::Field*> arguments;  ///< what the part gives to parameters and ports
  std::map<std::string_view, const ast::Field*> ports;
  Trace trace;  ///< from the part's declaration outwards
  std::size_t constraints_so_far = 0;

  bool is_part() const { return made_in != nullptr; }
  Symbol* find(std::string_view symbol);
  const Symbol* find(std::string_view symbol) const;
  /// The name in messages and columns of what the scope calls `element`.
  std::string path_of(const std::string& element) const { return name.empty() ? element : name + "." + element; }
};

struct Symbols {
  std::map<std::string, const ast::Module*, std::less<>> modules;
  std::deque<Scope> scopes;  ///< the first is the model's
  std::deque<Definition> definitions;
  std::deque<Frame> frames;
  std::vector<Particle> particles;  ///< in order of declaration
  std::vector<Variable> variables;  ///< in order of declaration
  std::map<long, Element> numbered_particles;
  bool numbers_complete = true;
  std::set<const ast::Declarator*> used;  ///< of definitions
};

/// What `name` stands for in `frame` and those around it.
const Frame* find_index(const Frame* frame, std::string_view name);
Definition* find_local(const Frame* frame, std::string_view name);

}  // namespace mbcc::model
