#pragma once
// The closed set of methods of integration, from the table in methods.def, and what a model asks of it.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "model/system.hpp"

namespace mbcc::model {

enum class Steps : std::uint8_t { Constant, Chosen };
enum class Code : std::uint8_t { None, Series, Tangent };

struct Method {
  std::string_view name;
  std::string_view type;  ///< in the runtime
  Steps steps;
  Code needs;
};

inline constexpr std::array methods = {
#define MBCC_METHOD(name, type, steps, needs) Method{#name, #type, Steps::steps, Code::needs},
#include "model/methods.def"
};

/// What chooses one of the methods that choose their steps.
inline constexpr std::string_view automatic = "auto";

/// What `method` may be in a model: the methods, and `auto`.
std::vector<std::string_view> method_names();

/// The methods that are compiled with a model: the one that its runs take unless they are told otherwise, and for
/// `auto` all among which it chooses. The others are in the library.
std::vector<Method> methods_of(const Integration& integration);

/// Whether one of these needs such code.
bool needs(const Integration& integration, Code code);

/// Whether a program has to be compiled for a method to run it, or for `auto` to choose among all there are.
bool needs_own_program(std::string_view method);

}  // namespace mbcc::model
