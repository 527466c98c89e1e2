#pragma once
// The names of a model: one table for all files, with the elements that loops make of a name.
//
// A name stands for one kind of thing and has the same number of indices everywhere. Names are visible in the whole
// model, in any order, indexed ones declared in loops too; a `let` without index inside a loop is visible in one pass
// of that loop only. Outputs are columns, not names: no expression refers to them.

#include <cstdint>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/value.hpp"
#include "syntax/ast.hpp"

namespace mbcc::model {

using Indices = std::vector<long>;

struct IndicesHash {
  std::size_t operator()(const Indices& indices) const;
};

/// A `constant`, `parameter` or `let`, evaluated when first used.
struct Definition;

/// One pass of a loop or sum: the value of its index, and the definitions that are local to it.
struct Frame {
  const Frame* outer = nullptr;
  std::string_view index;
  long value = 0;
  Span index_span;
  std::vector<Definition*> locals;
};

enum class SymbolKind { Constant, Parameter, Let, Particle, Constraint };
std::string_view describe(SymbolKind kind);  ///< "a parameter"

struct Definition {
  SymbolKind kind = SymbolKind::Let;
  const ast::Declarator* declarator = nullptr;
  const ast::Expression* expression = nullptr;
  const Frame* frame = nullptr;  ///< where it is declared
  std::string name;              ///< with its indices
  ParameterId parameter{};       ///< of a parameter
  enum class State { Waiting, Active, Done } state = State::Waiting;
  Value value;
};

struct Particle {
  std::string name;          ///< `bob`, `p[3]`; empty for numbered ones
  long number = 0;           ///< from 1; 0 for named ones
  std::size_t position = 0;  ///< in order of declaration, from 0
  const ast::Particle* syntax = nullptr;
  Span statement;
  const Frame* frame = nullptr;
};
std::string describe(const Particle& particle);  ///< "particle 1", "`bob`"

struct Element {
  std::size_t position = 0;  ///< among the definitions, particles
  Span span;
};

struct Symbol {
  SymbolKind kind = SymbolKind::Let;
  Span span;  ///< of the first declaration
  std::size_t index_count = 0;
  bool complete = true;  ///< false if a loop that declares elements of it could not be unrolled
  std::unordered_map<Indices, Element, IndicesHash> elements;
};

struct Symbols {
  std::map<std::string, Symbol, std::less<>> table;
  std::set<std::string, std::less<>> refused;  ///< declared, but not as it should be; using them is no new mistake
  std::deque<Definition> definitions;
  std::deque<Frame> frames;
  std::vector<Particle> particles;  ///< in order of declaration
  std::map<long, Element> numbered_particles;
  bool numbers_complete = true;
  std::set<const ast::Declarator*> used;  ///< of definitions

  Symbol* find(std::string_view name);
};

/// What `name` stands for in `frame` and those around it.
const Frame* find_index(const Frame* frame, std::string_view name);
Definition* find_local(const Frame* frame, std::string_view name);

}  // namespace mbcc::model
