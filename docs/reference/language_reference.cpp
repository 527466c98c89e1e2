// Fills language.md.in: `language_reference TEMPLATE MODEL.ebnf` prints the page on the language.

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <vector>

#include "emit/templates.hpp"
#include "graph/evaluate.hpp"
#include "graph/print.hpp"

namespace {

using namespace mbcc;
using graph::Expr;
using graph::OperatorRow;

std::string read(const char* path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The text of each production of a grammar, by its name.
cpp::Values productions(const std::string& grammar) {
  cpp::Values found;
  std::istringstream lines(grammar);
  std::string name, text;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t word = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
    if (name.empty() && word != 0 && word != std::string::npos && line.find(" = ") != std::string::npos) {
      name = line.substr(0, word);
    }
    if (!name.empty()) {
      text += line + "\n";
      if (line.back() == '.') {
        found[name] = text;
        name.clear();
        text.clear();
      }
    }
  }
  return found;
}

/// The derivatives of an operator by its operands, in the language of models; r is its value.
std::vector<std::string> derivatives(const OperatorRow& row) {
  graph::Graph graph;
  const std::array leaves = {graph.leaf(graph::Kind::Coordinate, 0), graph.leaf(graph::Kind::Coordinate, 1)};
  const Expr value = graph.leaf(graph::Kind::Coordinate, 2);
  std::array<const Expr*, 3> operands{};
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.arity); ++i) {
    operands[i] = &leaves[i];
  }
  const auto name = [](const graph::Node& leaf) { return std::string(1, "abr"[leaf.index]); };
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < static_cast<std::size_t>(row.arity); ++i) {
    const std::string line = print(std::array{std::pair(std::string("d"), slope(row.op, i, value, operands))}, name);
    texts.push_back(fmt::format("`{}`", line.substr(4, line.size() - 5)));
  }
  texts.resize(2);
  return texts;
}

bool is_function(const OperatorRow& row) { return graph::find_function(row.spelling) == row.op; }

/// `a ^ b`, `-a`, `atan2(a, b)`.
std::string call(const OperatorRow& row) {
  if (is_function(row)) {
    return fmt::format("{}({})", row.spelling, row.arity == 1 ? "a" : "a, b");
  }
  return row.arity == 1 ? fmt::format("{}a", row.spelling) : fmt::format("a {} b", row.spelling);
}

std::string table(std::string_view title, const std::vector<OperatorRow>& rows) {
  std::string text = fmt::format("| {} | d/da | d/db |\n|---|---|---|\n", title);
  for (const OperatorRow& row : rows) {
    const std::vector<std::string> slopes = derivatives(row);
    text += fmt::format("| `{}` | {} | {} |\n", call(row), slopes[0], slopes[1]);
  }
  return text;
}

/// Comparisons and `if` choose, and have no derivatives of their own.
std::vector<OperatorRow> rows_where(bool function) {
  std::vector<OperatorRow> rows;
  for (const OperatorRow& row : graph::operator_table) {
    if (is_function(row) == function && row.arity < 3 && precedence(row.op) != graph::Precedence::Comparison) {
      rows.push_back(row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const OperatorRow& a, const OperatorRow& b) { return precedence(a.op) > precedence(b.op); });
  return rows;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: language_reference TEMPLATE MODEL.ebnf\n";
    return 2;
  }
  const std::string page = read(argv[1]);
  cpp::Values values = productions(read(argv[2]));
  values["operators"] = table("operator", rows_where(false));
  values["functions"] = table("function, of value r", rows_where(true));
  for (const auto& [name, text] : values) {
    if (page.find("@" + name + "@") == std::string::npos) {
      std::cerr << argv[1] << ": there is no place for `" << name << "`\n";
      return 1;
    }
  }
  std::cout << cpp::fill(page, values);
  return 0;
}
