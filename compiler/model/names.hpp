#pragma once
// The names that the language itself gives: variables of numbered particles, members of particles, functions,
// constants.

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mbcc::model {

inline constexpr std::array<std::string_view, 3> axis_names = {"x", "y", "z"};

/// What a particle has for each axis, or as a whole: `x`, `vx`, `position`, `velocity`.
struct Member {
  bool is_velocity = false;
  std::optional<std::size_t> axis;  ///< absent: the vector
};

/// `x1`, `vz12`: a member of a numbered particle.
struct NumberedVariable {
  Member member;
  long particle = 1;
};

std::optional<std::size_t> find_axis(std::string_view name);  ///< `x`, `y`, `z`
std::optional<Member> find_member(std::string_view name);
std::optional<NumberedVariable> find_numbered_variable(std::string_view name);

/// Members that exist in a model of the given dimension.
std::vector<std::string_view> member_names(int dimension);

/// Why a name that looks like a variable of a numbered particle is none, in words that follow a colon; empty if the
/// name does not look like one. `particles` is the number of numbered particles.
std::string why_no_variable(std::string_view name, int dimension, long particles);

/// What the language means by a name that cannot be declared ("a function"); empty if it can.
std::string_view reserved_as(std::string_view name);

/// Functions of the language beyond the operator table: `dot`, `cross`, `norm`.
inline constexpr std::array<std::string_view, 3> vector_functions = {"dot", "cross", "norm"};

std::vector<std::string_view> function_names();
bool is_function(std::string_view name);

/// `p[3]`, `q[1,2]`; the bare name without indices.
std::string element_name(std::string_view name, const std::vector<long>& indices);

/// "no index", "1 index", "2 indices".
std::string indices_taken(std::size_t count);

/// "1 argument", "3 components".
std::string count_of(std::size_t count, std::string_view noun);

}  // namespace mbcc::model
