#include "rules.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <regex>
#include <set>
#include <sstream>

namespace mbcc::layers {
namespace {

constexpr std::array<std::string_view, 12> order = {"source",  "diagnostics", "graph",  "syntax", "model", "mechanics",
                                                    "program", "emit",        "dialog", "figure", "page",  "driver"};

std::optional<std::size_t> layer_of(std::string_view path) {
  const auto found = std::find(order.begin(), order.end(), path.substr(0, path.find('/')));
  return found == order.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - order.begin()));
}

bool starts_with(const std::string& text, std::string_view prefix) { return text.rfind(prefix, 0) == 0; }

bool is_source(std::string_view path) { return path.substr(path.rfind('.')) == ".cpp"; }

std::optional<std::string> included_by(const std::string& line) {
  static const std::regex include(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
  std::smatch match;
  return std::regex_search(line, match, include) ? std::optional(match[1].str()) : std::nullopt;
}

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
  static const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::vector<std::string> broken;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (const auto included = included_by(line)) {
      if (auto rule = broken_include(path, *included)) {
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

namespace {

bool reaches(const std::string& prefix, const std::string& path, const Files& files, std::set<std::string>& visited) {
  const auto file = files.find(path);
  if (file == files.end() || !visited.insert(path).second) {
    return false;
  }
  std::istringstream lines(file->second);
  for (std::string line; std::getline(lines, line);) {
    const auto included = included_by(line);
    if (included && (starts_with(*included, prefix) || reaches(prefix, *included, files, visited))) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::string> sources_that_reach(const std::string& prefix, const Files& files) {
  std::vector<std::string> found;
  for (const auto& [path, text] : files) {
    std::set<std::string> visited;
    if (is_source(path) && reaches(prefix, path, files, visited)) {
      found.push_back(path);
    }
  }
  return found;
}

}  // namespace mbcc::layers
