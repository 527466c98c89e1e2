// A part means the same in any tree, and costs nothing.

#include <catch2/catch.hpp>
#include <regex>

#include "driver/interpreted_model.hpp"
#include "program/schedule.hpp"
#include "support/compiled.hpp"
#include "support/emitted_models.hpp"
#include "support/model_states.hpp"
#include "support/random.hpp"

namespace mbcc::test {
namespace {

/// A chain of eight bobs, closed by a rod from the last to a wall, with a spring between the third and the sixth.
struct Tree {
  std::string text;
  std::vector<std::string> bobs;  ///< the paths of the eight bobs, along the chain
};

std::string spring_and_rod(const std::string& third, const std::string& sixth, const std::string& last) {
  return "let pull = " + sixth + ".position - " + third + ".position\n" +  //
         "force on " + third + " = 40*pull\nforce on " + sixth + " = -40*pull\n" + "constraint end : norm(" + last +
         ".position - (8, -1))^2 = 1\n";
}

const std::string link = R"(
module Link(k) {
  port base
  particle bob { mass = 1 + k/4; position = (k, 0) }
  constraint rod : norm(bob.position - base) = 1
  force on base = 0.1*bob.velocity
  point tip = bob.position
}
)";

/// All in the model itself.
Tree flat() {
  Tree tree{
      "constant N = 8\nfor k in 1..N { particle p[k] { mass = 1 + k/4; position = (k, 0) } }\n"
      "constraint rod[1] : norm(p[1].position) = 1\n"
      "for k in 2..N { constraint rod[k] : norm(p[k].position - p[k-1].position) = 1\n"
      "force on p[k-1] = 0.1*p[k].velocity }\n" +
          spring_and_rod("p[3]", "p[6]", "p[8]"),
      {}};
  for (int k = 1; k <= 8; ++k) {
    tree.bobs.push_back(fmt::format("p[{}]", k));
  }
  return tree;
}

/// Links in pairs, pairs in fours, fours in the whole; declared from the end backwards.
Tree pairs() {
  Tree tree{link + R"(
module Pair(k) {
  port base
  part b = Link(k = k + 1) { base = a.tip }
  part a = Link(k = k) { base = base }
  point tip = b.tip
}
module Four(k) {
  part b = Pair(k = k + 2) { base = a.tip }
  part a = Pair(k = k) { base = base }
  point tip = b.tip
  port base
}
part far = Four(k = 5) { base = near.tip }
part near = Four(k = 1) { base = (0, 0) }
)" + spring_and_rod("near.b.a.bob", "far.a.b.bob", "far.b.b.bob"),
            {}};
  for (const std::string four : {"near", "far"}) {
    for (const std::string pair : {"a", "b"}) {
      for (const std::string single : {"a", "b"}) {
        tree.bobs.push_back(four + "." + pair + "." + single + ".bob");
      }
    }
  }
  return tree;
}

/// An array of links in one module, with what closes the chain.
Tree one_module() {
  Tree tree{link + R"(
module Whole(N, anchor = (0, 0)) {
  part link[1] = Link(k = 1) { base = anchor }
  for k in 2..N { part link[k] = Link(k = k) { base = link[k-1].tip } }
)" + spring_and_rod("link[3].bob", "link[6].bob", "link[N].bob") +
                "}\nconstant N = 8\npart all = Whole(N = N)\n",
            {}};
  for (int k = 1; k <= 8; ++k) {
    tree.bobs.push_back(fmt::format("all.link[{}].bob", k));
  }
  return tree;
}

/// Speeds and accelerations of the bobs in order, at a state that is given bob by bob: x, y, vx, vy.
std::vector<double> rates_of(const Tree& tree, const std::vector<double>& state_by_bob) {
  const Compilation c = compiled("dimension 2\ngravity (0, -9.81)\n" + tree.text);
  InterpretedModel model(*c.program, *c.system, c.sources);
  std::vector<double> state = start(model);
  std::vector<std::size_t> places;
  for (const std::string& bob : tree.bobs) {
    for (const std::string axis : {".x", ".y"}) {
      const auto is_named = [&](const model::Coordinate& coordinate) { return coordinate.name == bob + axis; };
      const auto& all = c.system->coordinates;
      const auto found = std::find_if(all.begin(), all.end(), is_named);
      REQUIRE(found != all.end());
      places.push_back(static_cast<std::size_t>(found - all.begin()));
    }
  }
  const std::size_t half = places.size();
  for (std::size_t i = 0; i < half; ++i) {
    state[places[i]] = state_by_bob[i];
    state[half + places[i]] = state_by_bob[half + i];
  }
  std::vector<double> rates = state;
  model.set_time(0);
  model.rates(state, rates);
  std::vector<double> ordered;
  for (const std::size_t offset : {std::size_t{0}, half}) {
    for (const std::size_t place : places) {
      ordered.push_back(rates[offset + place]);
    }
  }
  return ordered;
}

/// A chain of so many links, of parts or of plain statements.
std::string long_chain(bool of_parts) {
  const std::string plain = R"(
for i in 1..N { particle p[i] { mass = m; position = (i*L, 0, 0) } }
constraint rod[1] : norm(p[1].position - (0, 0, 0)) = L
for i in 2..N { constraint rod[i] : norm(p[i].position - p[i-1].position) = L }
)";
  const std::string parts = R"(
module Link(m, L, start) {
  port base
  particle bob { mass = m; position = start }
  constraint rod : norm(bob.position - base) = L
}
part link[1] = Link(m = m, L = L, start = (L, 0, 0)) { base = (0, 0, 0) }
for i in 2..N { part link[i] = Link(m = m, L = L, start = (i*L, 0, 0)) { base = link[i-1].bob.position } }
)";
  return "constant N = 100\nparameter L = 0.1\nparameter m = 2\ngravity (0, 0, -9.81)\n" + (of_parts ? parts : plain);
}

}  // namespace

TEST_CASE("a system has the same accelerations along any tree of parts") {
  Random random(7);
  const std::vector<Tree> trees = {flat(), pairs(), one_module()};
  for (int sample = 0; sample < 5; ++sample) {
    std::vector<double> state;
    for (int k = 1; k <= 8; ++k) {
      state.insert(state.end(), {k + random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3)});
    }
    for (int i = 0; i < 16; ++i) {
      state.push_back(random.uniform(-1, 1));
    }
    const std::vector<double> expected = rates_of(trees[0], state);
    double largest = 0;
    for (const double value : expected) {
      largest = std::max(largest, std::abs(value));
    }
    for (std::size_t tree = 1; tree < trees.size(); ++tree) {
      const std::vector<double> rates = rates_of(trees[tree], state);
      INFO(trees[tree].text);
      REQUIRE(rates.size() == expected.size());
      for (std::size_t i = 0; i < rates.size(); ++i) {
        // Rounding: other orders of sums and of elimination. The rows' condition is a few hundred at these states.
        CHECK(std::abs(rates[i] - expected[i]) <= 1e-12 * largest);
      }
    }
  }
}

TEST_CASE("an array of parts becomes the program that the loop without parts becomes") {
  const Compilation plain = compiled(long_chain(false));
  const Compilation parts = compiled(long_chain(true));
  const std::string renamed = std::regex_replace(
      std::regex_replace(print(*parts.program, *parts.system), std::regex("link(\\[\\d+\\])\\.bob"), "p$1"),
      std::regex("link(\\[\\d+\\])\\.rod"), "rod$1");
  CHECK(renamed == print(*plain.program, *plain.system));
  CHECK(has_rolled_loops(emit(*parts.program, *parts.system, parts.sources, {true, false})));
}

}  // namespace mbcc::test
