#include "rules.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <sstream>

namespace mbcc::layers {
namespace {

constexpr std::array<std::string_view, 9> order = {"source",    "diagnostics", "graph", "syntax", "model",
                                                   "mechanics", "program",     "emit",  "driver"};

std::optional<std::size_t> layer_of(std::string_view path) {
  const auto found = std::find(order.begin(), order.end(), path.substr(0, path.find('/')));
  return found == order.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - order.begin()));
}

bool starts_with(const std::string& text, std::string_view prefix) { return text.rfind(prefix, 0) == 0; }

bool is_header(std::string_view path) { return path.substr(path.rfind('.')) == ".hpp"; }

/// The operator table spells each operator in C++ too: one place for all that depends on which operator it is.
bool is_emitters(std::string_view path) {
  return path.substr(0, path.find('/')) == "emit" || path == "graph/operators.def";
}

std::optional<std::string> broken_include(std::string_view path, const std::string& included) {
  const std::size_t own = layer_of(path).value();
  const std::optional<std::size_t> other = layer_of(included);
  if (other && *other > own) {
    return "includes " + included + ", which is to its right";
  }
  if (starts_with(included, "mbrt/") && order[own] != "driver") {
    return "includes " + included + ", which belongs to what is emitted";
  }
  if (starts_with(included, "boost/") && (order[own] != "syntax" || is_header(path))) {
    return "includes " + included + " outside of the parser";
  }
  if (starts_with(included, "Eigen/") && is_header(path)) {
    return "includes " + included + " in a header";
  }
  return std::nullopt;
}

/// A literal that ends a C++ statement, opens a definition or names the standard library. Braces tell nothing: models
/// and format strings have them too.
bool holds_code(const std::string& literal) {
  static const std::regex code(R"(;\\n|std::\w|#include|\b(return|const|auto|double|int|void) \w+.*[;(=])");
  return std::regex_search(literal, code);
}

}  // namespace

std::vector<std::string> broken_rules(std::string_view path, std::string_view text) {
  if (!layer_of(path)) {
    return {"is in no layer"};
  }
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<std::string> broken;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include)) {
      if (auto rule = broken_include(path, match[1])) {
        broken.push_back(*std::move(rule));
      }
      continue;
    }
    if (is_emitters(path)) {
      continue;
    }
    for (std::sregex_iterator at(line.begin(), line.end(), literal), end; at != end; ++at) {
      if (holds_code((*at)[1])) {
        broken.push_back("has C++ text outside of emit: \"" + (*at)[1].str() + "\"");
      }
    }
  }
  return broken;
}

}  // namespace mbcc::layers
