#include "emit/names.hpp"

#include <algorithm>
#include <array>

namespace mbcc::cpp {

namespace {

/// Keywords, and the names that emitted code uses for itself.
constexpr std::array reserved = {"alignas",
                                 "alignof",
                                 "and",
                                 "and_eq",
                                 "asm",
                                 "auto",
                                 "bitand",
                                 "bitor",
                                 "bool",
                                 "break",
                                 "case",
                                 "catch",
                                 "char",
                                 "char16_t",
                                 "char32_t",
                                 "char8_t",
                                 "class",
                                 "co_await",
                                 "co_return",
                                 "co_yield",
                                 "compl",
                                 "concept",
                                 "const",
                                 "const_cast",
                                 "consteval",
                                 "constexpr",
                                 "constinit",
                                 "continue",
                                 "decltype",
                                 "default",
                                 "delete",
                                 "do",
                                 "double",
                                 "dynamic_cast",
                                 "else",
                                 "enum",
                                 "explicit",
                                 "export",
                                 "extern",
                                 "false",
                                 "float",
                                 "for",
                                 "friend",
                                 "goto",
                                 "if",
                                 "inline",
                                 "int",
                                 "long",
                                 "mutable",
                                 "namespace",
                                 "new",
                                 "noexcept",
                                 "not",
                                 "not_eq",
                                 "nullptr",
                                 "operator",
                                 "or",
                                 "or_eq",
                                 "private",
                                 "protected",
                                 "public",
                                 "register",
                                 "reinterpret_cast",
                                 "requires",
                                 "return",
                                 "short",
                                 "signed",
                                 "sizeof",
                                 "static",
                                 "static_assert",
                                 "static_cast",
                                 "struct",
                                 "switch",
                                 "template",
                                 "this",
                                 "thread_local",
                                 "throw",
                                 "true",
                                 "try",
                                 "typedef",
                                 "typeid",
                                 "typename",
                                 "union",
                                 "unsigned",
                                 "using",
                                 "virtual",
                                 "void",
                                 "volatile",
                                 "wchar_t",
                                 "while",
                                 "xor",
                                 "xor_eq",
                                 "linux",
                                 "unix",
                                 "errno",
                                 "main",
                                 "Model",
                                 "State",
                                 "std",
                                 "mbrt",
                                 "y",
                                 "rate",
                                 "direction",
                                 "change",
                                 "tangent",
                                 "shift",
                                 "rows",
                                 "k",
                                 "s",
                                 "order",
                                 "Series",
                                 "expand",
                                 "added",
                                 "t",
                                 "position",
                                 "velocity",
                                 "acceleration",
                                 "outputs",
                                 "values",
                                 "island",
                                 "prepare",
                                 "project",
                                 "shift_positions",
                                 "shift_velocities",
                                 "rates",
                                 "energy",
                                 "coordinates",
                                 "speeds",
                                 "constraints",
                                 "parameters",
                                 "set_time",
                                 "initial_state",
                                 "description",
                                 "island_rows",
                                 "constraint_errors",
                                 "applied_forces",
                                 "assert",
                                 "stdin",
                                 "stdout",
                                 "stderr",
                                 "EOF",
                                 "NULL",
                                 "NAN",
                                 "INFINITY",
                                 "HUGE_VAL",
                                 "signbit",
                                 "isnan",
                                 "isinf",
                                 "M_PI",
                                 "M_E",
                                 "i386"};

/// Emitted classes have functions `rows_1`, `climb_1`, ..., and numbers `order_1`, ...
bool is_reserved(std::string_view name) {
  constexpr std::array prefixes = {"rows_", "climb_", "order_", "inverse_", "impulse_"};
  return std::any_of(prefixes.begin(), prefixes.end(), [&](const char* prefix) { return name.starts_with(prefix); }) ||
         std::any_of(reserved.begin(), reserved.end(), [&](const char* word) { return name == word; });
}

bool is_letter_or_digit(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

}  // namespace

std::string mangle(std::string_view name) {
  std::string mangled;
  for (const char c : name) {
    if (is_letter_or_digit(c)) {
      mangled += c;
    } else if (!mangled.empty() && mangled.back() != '_') {
      mangled += '_';
    }
  }
  while (!mangled.empty() && mangled.back() == '_') {
    mangled.pop_back();
  }
  if (mangled.empty() || (mangled.front() >= '0' && mangled.front() <= '9')) {
    mangled.insert(0, "n");
  }
  // Words in capitals alone may be macros of a C library.
  const bool may_be_macro =
      mangled.size() > 1 && std::none_of(mangled.begin(), mangled.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return is_reserved(mangled) || may_be_macro ? mangled + "_v" : mangled;
}

Scope Scope::nested() const {
  Scope inner;
  inner.outer_ = this;
  inner.counters_ = counters_;
  return inner;
}

bool Scope::is_taken(const std::string& name) const {
  return taken_.contains(name) || (outer_ != nullptr && outer_->is_taken(name));
}

std::string Scope::declare(std::string_view name) {
  const std::string mangled = mangle(name);
  std::string unique = mangled;
  for (int n = 2; is_taken(unique); ++n) {
    unique = mangled + "_" + std::to_string(n);
  }
  taken_.insert(unique);
  return unique;
}

std::string Scope::enumerate(const std::string& prefix) {
  std::string name;
  do {
    name = prefix + std::to_string(++counters_[prefix]);
  } while (is_taken(name));
  taken_.insert(name);
  return name;
}

}  // namespace mbcc::cpp
