#pragma once
// Names of the model as C++ identifiers.

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace mbcc::cpp {

/// `p[3].x` as `p_3_x`; never a keyword, a reserved or an empty identifier.
std::string mangle(std::string_view name);

/// Whether the C library has something of that name in the global namespace, which no namespace may then be called.
bool is_global_name(std::string_view name);

/// Hands out identifiers that are distinct within one scope and those around it.
class Scope {
 public:
  /// A scope within this one, which must outlive it.
  Scope nested() const;

  /// `name` mangled, with a number behind it if it was given out before.
  std::string declare(std::string_view name);
  /// `prefix` with the next free number behind it.
  std::string enumerate(const std::string& prefix);

 private:
  bool is_taken(const std::string& name) const;

  const Scope* outer_ = nullptr;
  std::set<std::string> taken_;
  std::map<std::string, int> counters_;  ///< by prefix
};

}  // namespace mbcc::cpp
