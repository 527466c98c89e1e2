// A and b of every constraint, by three independent ways: as mbcc differentiates, by the FEED form with the paper's
// formulas, and by differences along a motion in quadruple precision.

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <limits>

#include "graph/feed.hpp"
#include "support/compiled.hpp"
#include "support/quad.hpp"
#include "support/random_scene.hpp"
#include "support/run_program.hpp"
#include "support/tracked.hpp"

namespace mbcc::mechanics {
namespace {

using graph::Feed;
using graph::Kind;
using graph::Node;
using test::Quad;
using test::Random;
using test::Tracked;

constexpr double eps = std::numeric_limits<double>::epsilon();

/// A model's variables in the order (t, coordinates, speeds).
struct State {
  const model::System& system;
  std::vector<double> values;

  std::size_t index_of(const Node& leaf) const {
    return leaf.kind == Kind::Time ? 0 : 1 + leaf.index + (leaf.kind == Kind::Speed ? system.coordinates.size() : 0);
  }
  /// Which speed is the rate of a coordinate, in models where each is that of one.
  std::size_t speed_index(std::size_t coordinate) const { return system[system.coordinates[coordinate].rate].index; }
  double speed_of_coordinate(std::size_t i) const { return values[1 + system.coordinates.size() + speed_index(i)]; }
};

State random_state(const Compilation& c, Random& random) {
  State state{*c.system, {random.uniform(0, 2)}};
  for (const double value : test::start_state(c)) {
    state.values.push_back(value + random.uniform(-0.3, 0.3));
  }
  return state;
}

template <class T>
std::vector<T> evaluate(const std::vector<Expr>& expressions, const State& state) {
  const auto leaf = [&](const Node& node) {
    return T(node.kind == Kind::Constant    ? node.value
             : node.kind == Kind::Parameter ? state.system.parameters[node.index].value
                                            : state.values[state.index_of(node)]);
  };
  return graph::evaluate<T>(expressions.front().graph(), expressions, leaf);
}

Feed feed_of(Expr constraint, const State& state) {
  const std::size_t n = state.values.size();
  const auto leaf = [&](const Node& node) {
    if (node.kind == Kind::Constant || node.kind == Kind::Parameter) {
      return Feed::constant(node.kind == Kind::Constant ? node.value : state.system.parameters[node.index].value, n,
                            Feed::Order::Second);
    }
    return Feed::variable(state.values[state.index_of(node)], state.index_of(node), n, Feed::Order::Second);
  };
  return graph::evaluate<Feed>(constraint.graph(), std::array{constraint}, leaf).front();
}

/// A number with the size of the terms whose sum it is.
struct Sum {
  double value = 0, size = 0;
  void add(double term) {
    value += term;
    size += std::abs(term);
  }
};

/// The paper: -[1 v'] H [1; v] where holonomic, -(dg/dt + dg/dx . v) where not.
Sum b_of_paper(const Feed& feed, const State& state, bool holonomic) {
  std::vector<double> motion(state.values.size());
  motion[0] = 1;
  for (std::size_t i = 0; i < state.system.coordinates.size(); ++i) {
    motion[1 + i] = state.speed_of_coordinate(i);
  }
  Sum b;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (!holonomic) {
      b.add(-feed.first(i) * motion[i]);
    }
    for (std::size_t j = 0; holonomic && j < motion.size(); ++j) {
      b.add(-feed.second(i, j) * motion[i] * motion[j]);
    }
  }
  return b;
}

/// d2h/dt2 (holonomic) or dg/dt along the motion through `state` with constant accelerations, by differences. The
/// five-point formulas with a step of 1e-5 leave 1e-20 times higher derivatives, and rounding 1e-34 / 1e-10.
double by_differences(Expr constraint, bool holonomic, const State& state, const std::vector<double>& accelerations) {
  const Quad h("1e-5");
  const std::size_t coordinates = state.system.coordinates.size();
  const auto at = [&](int steps) {
    const Quad dt = steps * h;
    const auto leaf = [&](const Node& node) -> Quad {
      const auto u = [&](std::size_t j) { return Quad(state.values[1 + coordinates + j]); };
      switch (node.kind) {
        case Kind::Constant:
          return node.value;
        case Kind::Parameter:
          return state.system.parameters[node.index].value;
        case Kind::Time:
          return state.values[0] + dt;
        case Kind::Speed:
          return u(node.index) + accelerations[node.index] * dt;
        default: {
          const std::size_t j = state.speed_index(node.index);
          return state.values[1 + node.index] + u(j) * dt + accelerations[j] * dt * dt / 2;
        }
      }
    };
    return graph::evaluate<Quad>(constraint.graph(), std::array{constraint}, leaf).front();
  };
  const Quad derivative = holonomic ? (16 * (at(1) + at(-1)) - (at(2) + at(-2)) - 30 * at(0)) / (12 * h * h)
                                    : (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
  return static_cast<double>(derivative);
}

void judge_row(const Compilation& c, const Row& row, const State& state, Random& random) {
  const bool holonomic = c.system->constraints[row.constraint].holonomic;
  const std::size_t coordinates = c.system->coordinates.size();
  const Expr constraint = c.equations.constraints[row.constraint];
  const Feed feed = feed_of(constraint, state);
  std::vector<Expr> expressions = {row.b, row.value, row.rate};
  for (const Entry& entry : row.entries) {
    expressions.push_back(entry.value);
  }
  const std::vector<Tracked> values = evaluate<Tracked>(expressions, state);
  if (!std::all_of(values.begin(), values.end(), [](const Tracked& value) { return std::isfinite(value.error); })) {
    return;  // at a jump
  }
  CAPTURE(c.system->constraints[row.constraint].name);
  CHECK(test::agree(values[1], feed.value()));

  // A: the partial derivatives, and no others.
  std::vector<double> a(c.system->speeds.size());
  for (std::size_t e = 0; e < row.entries.size(); ++e) {
    a[row.entries[e].speed] = values[3 + e].value;
    CHECK(std::abs(values[3 + e].value - feed.first(1 + (holonomic ? 0 : coordinates) + row.entries[e].speed)) <=
          8 * values[3 + e].error + 8 * eps * std::abs(values[3 + e].value));
  }
  for (std::size_t j = 0; j < a.size(); ++j) {
    const bool is_entry =
        std::any_of(row.entries.begin(), row.entries.end(), [&](const Entry& entry) { return entry.speed == j; });
    CHECK((is_entry || feed.first(1 + (holonomic ? 0 : coordinates) + j) == 0));
  }

  const Sum b = b_of_paper(feed, state, holonomic);
  // Each partial of FEED is a sum itself; a hundred roundings of the largest terms cover them.
  CHECK(std::abs(values[0].value - b.value) <= 8 * values[0].error + 100 * eps * b.size);

  std::vector<double> accelerations(a.size());
  Sum expected;
  for (std::size_t j = 0; j < a.size(); ++j) {
    accelerations[j] = random.uniform(-1, 1);
    expected.add(a[j] * accelerations[j]);
  }
  expected.add(-values[0].value);
  constexpr double of_the_differences = 1e-12;
  CHECK(std::abs(by_differences(constraint, holonomic, state, accelerations) - expected.value) <=
        8 * values[0].error + 100 * eps * (expected.size + b.size) + of_the_differences * std::max(1.0, b.size));

  Sum rate;
  for (std::size_t i = 0; holonomic && i <= coordinates; ++i) {
    rate.add(feed.first(i) * (i == 0 ? 1 : state.speed_of_coordinate(i - 1)));
  }
  CHECK(std::abs(values[2].value - (holonomic ? rate.value : feed.value())) <=
        8 * values[2].error + 100 * eps * rate.size);
}

/// The paper's formulas are for coordinates whose rates are speeds; uncoupled_test.cpp has the others.
bool has_plain_rates(const model::System& system) {
  return std::all_of(system.coordinates.begin(), system.coordinates.end(), [&](const model::Coordinate& coordinate) {
    return system[coordinate.rate].kind == model::ExpressionKind::Speed;
  });
}

void judge_all(const Compilation& c, int states, Random& random) {
  if (!has_plain_rates(*c.system)) {
    return;
  }
  for (int i = 0; i < states; ++i) {
    const State state = random_state(c, random);
    for (const Row& row : c.derivatives.rows) {
      judge_row(c, row, state, random);
    }
  }
}

}  // namespace

TEST_CASE("A and b of random scenes are those of the paper's formulas and of differences") {
  Random random(1);
  for (int scene = 0; scene < 150; ++scene) {
    const Compilation c = compile("scene.mbd", test::RandomScene(random).text(), {});  // contradictions do not matter
    INFO(c.sources[0].text());
    judge_all(c, 3, random);
  }
}

TEST_CASE("A and b of every example are those of the paper's formulas and of differences") {
  Random random(2);
  int examples = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(std::string(MBCC_SOURCE_DIR) + "/examples")) {
    if (file.path().extension() == ".mbd") {
      ++examples;
      INFO(file.path());
      const Compilation c = compile(file.path().string(), test::read_file(file.path()), {false, Stage::Derivatives});
      REQUIRE_FALSE(c.diagnostics.has_errors());
      judge_all(c, 2, random);
    }
  }
  CHECK(examples >= 12);
}

TEST_CASE("energy is kinetic and potential where forces are constant, and nothing elsewhere") {
  const Compilation c = test::compiled(R"(dimension 2
parameter g = 9.81
particle 1 { mass = 2; position = (0, 1); velocity = (1, 0); force = (3, 0) }
particle 2 { mass = 4; position = (0, 2) }
gravity (0, -g)
)");
  REQUIRE(c.derivatives.energy);
  State state{*c.system, {0, 0.5, 1.5, -1, 2.5, 3, -2, 0.25, 1}};
  const double kinetic = 0.5 * 2 * (9 + 4) + 0.5 * 4 * (0.0625 + 1);
  const double potential = 2 * 9.81 * 1.5 + 4 * 9.81 * 2.5 - 3 * 0.5;
  const Tracked energy = evaluate<Tracked>({*c.derivatives.energy}, state).front();
  CHECK(test::agree(energy, kinetic + potential));
  for (const char* force : {"-x1", "sin(t)", "-vx1"}) {
    const std::string text = std::string("dimension 1\nparticle 1 { mass = 1; position = 0; force = ") + force + " }\n";
    CHECK_FALSE(test::compiled(text).derivatives.energy);
  }
}

}  // namespace mbcc::mechanics
