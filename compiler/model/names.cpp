#include "model/names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "graph/operators.hpp"

namespace mbcc::model {
namespace {

constexpr std::array<std::string_view, 6> scalar_members = {"x", "y", "z", "vx", "vy", "vz"};

bool all_digits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The member at the front of `name` and what follows it, if that is empty or a number.
struct Shape {
  std::string_view member;
  std::string_view digits;
};
std::optional<Shape> shape_of(std::string_view name) {
  const std::size_t length = name.substr(0, 1) == "v" ? 2 : 1;
  const Shape shape{name.substr(0, length), name.size() > length ? name.substr(length) : std::string_view{}};
  const bool is_member = std::find(scalar_members.begin(), scalar_members.end(), shape.member) != scalar_members.end();
  if (!is_member || (!shape.digits.empty() && !all_digits(shape.digits))) {
    return std::nullopt;
  }
  return shape;
}

}  // namespace

std::optional<std::size_t> find_axis(std::string_view name) {
  const auto found = std::find(axis_names.begin(), axis_names.end(), name);
  if (found == axis_names.end()) {
    return std::nullopt;
  }
  return static_cast<std::size_t>(found - axis_names.begin());
}

std::optional<Member> find_member(std::string_view name) {
  if (name == "position" || name == "velocity") {
    return Member{name == "velocity", std::nullopt};
  }
  const bool is_velocity = name.substr(0, 1) == "v";
  const std::optional<std::size_t> axis = find_axis(name.substr(is_velocity ? 1 : 0));
  if (!axis) {
    return std::nullopt;
  }
  return Member{is_velocity, axis};
}

std::optional<NumberedVariable> find_numbered_variable(std::string_view name) {
  const std::optional<Shape> shape = shape_of(name);
  if (!shape || shape->digits.empty() || shape->digits.front() == '0') {
    return std::nullopt;
  }
  long number = 0;
  const auto [end, error] = std::from_chars(shape->digits.data(), shape->digits.data() + shape->digits.size(), number);
  if (error != std::errc{}) {
    return std::nullopt;
  }
  return NumberedVariable{*find_member(shape->member), number};
}

std::vector<std::string_view> member_names(int dimension) {
  std::vector<std::string_view> names = {"position", "velocity"};
  for (const std::string_view member : scalar_members) {
    if (static_cast<int>(*find_member(member)->axis) < dimension) {
      names.push_back(member);
    }
  }
  return names;
}

std::string why_no_variable(std::string_view name, int dimension, long particles) {
  if (name.substr(0, 1) == "t" && all_digits(name.substr(1))) {
    return "the time `t` has no number";
  }
  const std::optional<Shape> shape = shape_of(name);
  if (!shape) {
    return {};
  }
  if (static_cast<int>(*find_member(shape->member)->axis) >= dimension) {
    return fmt::format("dimension {} has no `{}`", dimension, shape->member.back());
  }
  if (shape->digits.empty()) {
    return fmt::format("it needs the number of a particle, as in `{}1`", name);
  }
  if (shape->digits.front() == '0') {
    return all_digits(shape->digits) && shape->digits.find_first_not_of('0') == std::string_view::npos
               ? "particles are numbered from 1"
               : "the number of a particle has no leading zero";
  }
  if (particles == 0) {
    return "the model has no numbered particles";
  }
  return fmt::format("there is no particle {}, numbers run from 1 to {}", shape->digits, particles);
}

std::string_view reserved_as(std::string_view name) {
  if (name == "t") {
    return "the time";
  }
  if (name == "pi") {
    return "a number of the language";
  }
  if (is_function(name)) {
    return "a function";
  }
  if (find_numbered_variable(name)) {
    return "a variable of a numbered particle";
  }
  return {};
}

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names(vector_functions.begin(), vector_functions.end());
  for (const graph::OperatorRow& row : graph::operator_table) {
    if (graph::find_function(row.spelling)) {
      names.push_back(row.spelling);
    }
  }
  return names;
}

bool is_function(std::string_view name) {
  return graph::find_function(name) ||
         std::find(vector_functions.begin(), vector_functions.end(), name) != vector_functions.end();
}

std::string element_name(std::string_view name, const std::vector<long>& indices) {
  return indices.empty() ? std::string(name) : fmt::format("{}[{}]", name, fmt::join(indices, ","));
}

std::string indices_taken(std::size_t count) {
  return count == 0 ? "no index" : count == 1 ? "1 index" : fmt::format("{} indices", count);
}

std::string count_of(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace mbcc::model
