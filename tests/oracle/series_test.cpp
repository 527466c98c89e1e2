// Emitted Taylor coefficients against those of the ordinary right-hand side: there the elimination itself is expanded,
// node by node, while emitted code solves with one factorisation for all orders.

#include "graph/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "emitted_case.hpp"
#include "mechanics/eliminate.hpp"
#include "support/model_states.hpp"
#include "support/random.hpp"

namespace mbcc::test {
namespace {

using graph::Expr;

/// Rates of the state as the ordinary kernel has them.
std::vector<Expr> rates_of(Compilation& c) {
  std::vector<Expr> rates = c.equations.kinematics;
  rates.insert(rates.end(), c.derivatives.free.begin(), c.derivatives.free.end());
  for (const mechanics::Island& island : c.derivatives.islands) {
    const mechanics::Elimination elimination = eliminate(island, c.derivatives, *c.graph);
    for (std::size_t j = 0; j < island.speeds.size(); ++j) {
      rates[c.equations.kinematics.size() + island.speeds[j]] = elimination.accelerations[j];
    }
  }
  return rates;
}

/// The state's coefficients from order 1 to `order`, at default parameters.
std::vector<double> expected(Compilation& c, double time, const std::vector<double>& state, std::size_t order) {
  const std::vector<Expr> rates = rates_of(c);
  std::vector<std::vector<double>> y{state};
  std::size_t m = 0;
  const graph::Series::LeafValue leaf = [&](const graph::Node& node) {
    switch (node.kind) {
      case graph::Kind::Parameter:
        return c.system->parameters[node.index].value;
      case graph::Kind::Time:
        return m == 0 ? time : m == 1 ? 1.0 : 0.0;
      case graph::Kind::Coordinate:
        return y[m][node.index];
      default:
        return y[m][c.system->coordinates.size() + node.index];
    }
  };
  graph::Series series(*c.graph, rates, leaf);
  std::vector<double> all;
  while (true) {
    std::vector<double> next;
    for (const Expr rate : rates) {
      next.push_back(series.of(rate)[m] / static_cast<double>(m + 1));
    }
    all.insert(all.end(), next.begin(), next.end());
    y.push_back(std::move(next));
    if (++m == order) {
      return all;
    }
    series.advance(leaf);
  }
}

/// `states` states a little off the start, and so a little off the constraints.
Case make_case(const std::string& name, const std::string& path, std::string text, std::size_t states) {
  Case result{name, compile(path, std::move(text), {false, Stage::Program, false, "taylor"}), {}};
  INFO(messages_of(result.compilation));
  REQUIRE_FALSE(result.compilation.diagnostics.has_errors());
  Random random(20050404 + name.size());
  for (std::size_t i = 0; i < states; ++i) {
    std::vector<double> state = start_state(result.compilation);
    for (double& value : state) {
      value += random.uniform(-1e-2, 1e-2);
    }
    result.question.times.push_back(random.uniform(0, 1));
    result.question.states.push_back(std::move(state));
  }
  return result;
}

/// Whether the two halves of a model's answer agree with the oracle; the first is of high order.
bool is_checked(Case& c, const std::vector<double>& answer, std::size_t i) {
  const std::vector<double>& state = c.question.states[i];
  const std::size_t size = state.size();
  const auto [high, low] = expanded_orders;
  if (answer.size() < (high + low) * size) {
    return false;
  }
  const double* const first = answer.data() + (answer.size() - (high + low) * size);
  for (std::size_t n = 0; n < low * size; ++n) {
    if (first[n] != first[high * size + n]) {
      INFO(c.name << ": coefficient " << n << " depends on the order that is asked for");
      CHECK(first[n] == first[high * size + n]);
    }
  }
  const std::vector<double> oracle = expected(c.compilation, c.question.times[i], state, high);
  for (std::size_t k = 0; k < high; ++k) {
    double largest = 0, difference = 0;
    for (std::size_t n = k * size; n < (k + 1) * size; ++n) {
      largest = std::max(largest, std::abs(oracle[n]));
      difference = std::max(difference, std::abs(oracle[n] - first[n]));
    }
    // Both solve with S, whose condition is up to 1e8 while the plain step holds: 1e-8 between two ways, at every order
    // of which the largest coefficient is a sum of some hundred products of the ones before.
    INFO(c.name << ", order " << k + 1);
    CHECK(difference <= 1e-8 * largest);
  }
  return true;
}

/// Builds all cases into one program and compares; returns the names of the cases with a state that has no series.
std::vector<std::string> compare(std::vector<Case>& cases) {
  const std::vector<Answers> answers = answers_of(cases);
  std::vector<std::string> refused;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    for (std::size_t i = 0; i < answers[c].size(); ++i) {
      if (!is_checked(cases[c], answers[c][i], i)) {
        refused.push_back(cases[c].name);
      }
    }
  }
  return refused;
}

}  // namespace

TEST_CASE("emitted coefficients of the published models are those of the ordinary right-hand side") {
  std::vector<Case> cases;
  for (const auto& file :
       std::filesystem::directory_iterator(std::filesystem::path(MBCC_SOURCE_DIR) / "tests/models")) {
    const std::string name = file.path().stem();
    // Those are other models for a shorter time.
    const bool is_other_run = name.ends_with("_t1") || name.ends_with("_t10") || name.ends_with("_presingular");
    if (file.path().extension() == ".mbd" && !is_other_run) {
      cases.push_back(make_case(name, file.path(), read_file(file.path()), 1));
    }
  }
  std::vector<std::string> refused = compare(cases);
  std::sort(refused.begin(), refused.end());
  // Bricard's mechanism is redundant throughout, the flyball governor's rods nearly so: no plain solve.
  CHECK(refused == std::vector<std::string>{"iftomm_a04_bricard", "iftomm_a05_flyball_particles"});
}

TEST_CASE("every operator has its series in emitted forces, and in constraints of both kinds") {
  std::vector<Case> cases;
  for (const graph::OperatorRow& row : graph::operator_table) {
    if (row.spelling.front() < 'a' || row.spelling.front() > 'z') {
      continue;  // + - * / ^ and comparisons are part of what follows
    }
    const std::string f(row.spelling);
    const auto call = [&](const std::string& a, const std::string& b) {
      return row.arity == 1   ? fmt::format("{}({}{})", f, f == "acosh" ? "2 + " : "", a)
             : row.arity == 2 ? fmt::format("{}({}, {})", f, a, b)
                              : fmt::format("{0}({1} < {2}, ({1})^1.5, {2})", f, a, b);
    };
    const std::string text = fmt::format(R"(dimension 2
particle 1 {{ mass = 1; position = (0.3, 0.6); velocity = (0.2, 0.1); force = ({}, -y1) }}
particle 2 {{ mass = 2; position = (0.3, {}); velocity = (0, 0) }}
particle 3 {{ mass = 2; position = (0.3, 0.5); velocity = (0.4, {}); force = (x3, -1) }}
constraint : y2 = {}
constraint : vy3 = {}
)",
                                         call("x1 + 0.2*vx1*t", "y1^3/(1 + x1^2)"), call("0.3", "0.47"),
                                         call("0.3", "0.4"), call("x2", "0.5 - 0.1*x2"), call("x3", "vx3"));
    cases.push_back(make_case("op_" + f, "op_" + f + ".mbd", text, 2));
  }
  CHECK(compare(cases).empty());
}

}  // namespace mbcc::test
