#include "model/symbols.hpp"

#include <fmt/format.h>

namespace mbcc::model {

std::size_t IndicesHash::operator()(const Indices& indices) const {
  std::uint64_t hash = indices.size();
  for (const long value : indices) {
    hash = (hash ^ static_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 32U;
  }
  return static_cast<std::size_t>(hash);
}

std::string_view describe(SymbolKind kind) {
  switch (kind) {
    case SymbolKind::Constant:
      return "a constant";
    case SymbolKind::Parameter:
      return "a parameter";
    case SymbolKind::Let:
      return "a `let`";
    case SymbolKind::Formal:
      return "a parameter of its module";
    case SymbolKind::Point:
      return "a point";
    case SymbolKind::Port:
      return "a port";
    case SymbolKind::Particle:
      return "a particle";
    case SymbolKind::Coordinate:
      return "a coordinate";
    case SymbolKind::Speed:
      return "a speed";
    case SymbolKind::State:
      return "a state";
    case SymbolKind::Constraint:
      return "a constraint";
    case SymbolKind::Part:
      return "a part";
  }
  return {};
}

SymbolKind kind_of(ast::VariableKind kind) {
  switch (kind) {
    case ast::VariableKind::Coordinate:
      return SymbolKind::Coordinate;
    case ast::VariableKind::Speed:
      return SymbolKind::Speed;
    case ast::VariableKind::State:
      break;
  }
  return SymbolKind::State;
}

std::string describe(const Particle& particle) {
  return particle.number > 0 ? fmt::format("particle {}", particle.number) : fmt::format("`{}`", particle.name);
}

Symbol* Scope::find(std::string_view symbol) {
  const auto found = table.find(symbol);
  return found == table.end() ? nullptr : &found->second;
}

const Symbol* Scope::find(std::string_view symbol) const {
  const auto found = table.find(symbol);
  return found == table.end() ? nullptr : &found->second;
}

const Frame* find_index(const Frame* frame, std::string_view name) {
  while (is_in_loop(frame) && frame->index != name) {
    frame = frame->outer;
  }
  return is_in_loop(frame) ? frame : nullptr;
}

Definition* find_local(const Frame* frame, std::string_view name) {
  for (; frame != nullptr; frame = frame->outer) {
    for (Definition* local : frame->locals) {
      if (local->declarator->name == name) {
        return local;
      }
    }
  }
  return nullptr;
}

}  // namespace mbcc::model
