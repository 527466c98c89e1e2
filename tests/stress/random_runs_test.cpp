// Random scenes, with redundant rows, nearly dependent ones and rows of every size, against the equation of motion in
// quadruple precision: u' by a singular value decomposition of the rows, nothing of elimination in it, integrated by
// extrapolation, nothing of the runtime's methods in it.
//
// The reference rounds its states to doubles. Both motions are therefore as exact as rounding and the tolerance, times
// what perturbations grow to in the scene, which a twin of the reference that starts beside it measures. Scenes that
// come near a change of rank, where the right side is not smooth, or that end in so short a time, are left out and
// counted.

#include <cstdio>
#include <cstdlib>
#include <mbrt/math.hpp>
#include <optional>

#include "driver/interpreted_model.hpp"
#include "extrapolation.hpp"
#include "oracle/exact.hpp"
#include "runs.hpp"
#include "support/compiled.hpp"
#include "support/model_states.hpp"
#include "support/random_scene.hpp"

namespace mbcc::test {
namespace {

constexpr double span = 0.1;
constexpr double tolerance = 1e-10;
using State = std::vector<double>;

/// Makes `mbcc run` interpret models, for as long as this lives: a thousand builds would take half an hour. Emitted
/// code and interpreter agree to the last bit (tests/random).
class WithoutCompiler {
 public:
  WithoutCompiler() : before_(std::getenv("CXX") == nullptr ? "" : std::getenv("CXX")) {
    setenv("CXX", "there-is-no-such-compiler", 1);
  }
  ~WithoutCompiler() { before_.empty() ? unsetenv("CXX") : setenv("CXX", before_.c_str(), 1); }
  WithoutCompiler(const WithoutCompiler&) = delete;
  WithoutCompiler& operator=(const WithoutCompiler&) = delete;

 private:
  std::string before_;
};

/// The equation of motion as a function of states. Speeds that no constraint touches have the rates of their forces.
struct Equation {
  explicit Equation(const Compilation& compilation)
      : exact(compilation), forces(*compilation.program, *compilation.system, compilation.sources) {
    test::start(forces);
  }

  State operator()(double t, const State& y) {
    State rate(y.size());
    forces.set_time(t);
    forces.rates(y, rate);
    is_known = is_known && mbrt::all_finite(rate);
    if (!is_known) {
      return State(y.size(), 0.0);
    }
    for (const ExactIsland& island : exact.at(t, y)) {
      is_known = is_known && !island.is_ambiguous && island.condition < 1e4;
      for (std::size_t j = 0; j < island.components.size(); ++j) {
        rate[island.components[j]] = static_cast<double>(island.acceleration[j]);
      }
    }
    return rate;
  }

  ExactModel exact;
  InterpretedModel forces;
  bool is_known = true;  ///< at all states so far; what follows is nothing
};

double largest_difference(const State& a, const State& b) {
  double largest = 0;
  for (std::size_t j = 0; j < a.size(); ++j) {
    largest = std::max(largest, std::abs(a[j] - b[j]));
  }
  return largest;
}

struct Reference {
  State end;
  double growth;  ///< of perturbations of the start
};

/// Nothing where the right side is not known well enough on the way.
std::optional<Reference> integrate_exactly(const Compilation& compilation) {
  Equation equation(compilation);
  const auto rate = [&](double t, const State& y) { return equation(t, y); };
  const State start = start_state(compilation);
  const Extrapolated<double> end = extrapolate<8>(rate, 0.0, start, span);
  if (!equation.is_known || !(end.doubt < tolerance)) {
    return std::nullopt;
  }
  constexpr double beside = 1e-7;
  State twin = start;
  for (std::size_t j = 0; j < twin.size(); ++j) {
    twin[j] += j % 2 == 0 ? beside : -beside;
  }
  return Reference{end.state, largest_difference(extrapolate<8>(rate, 0.0, twin, span).state, end.state) / beside};
}

/// Runs as many scenes as asked for; returns how many could be judged.
int judge_runs(int count, std::uint64_t seed) {
  const WithoutCompiler interpreted;
  const ScratchDirectory scratch;
  Random random(seed);
  int judged = 0;
  for (int scenes = 0; scenes < count;) {
    const std::string text = RandomScene(random).text();
    const Compilation compilation = compile("scene.mbd", text, {});
    if (compilation.diagnostics.has_errors()) {
      continue;
    }
    ++scenes;
    const std::optional<Reference> reference = integrate_exactly(compilation);
    if (!reference) {
      continue;
    }
    ++judged;
    INFO(text);
    write_file(scratch / "scene.mbd", text);
    const Run run = completed(scratch / "scene.mbd", "dop853", tolerance, {"--to", flag(span)});
    const double steps = run.summary["steps"];
    const auto& coordinates = compilation.system->coordinates;
    const auto& speeds = compilation.system->speeds;
    for (std::size_t j = 0; j < reference->end.size(); ++j) {
      const std::string& name = j < coordinates.size() ? coordinates[j].name : speeds[j - coordinates.size()].name;
      const double exact = reference->end[j];
      CAPTURE(name, steps, reference->growth);
      // A tolerance for each step, relative to the state and its size at the start, and the growth of it.
      CHECK(run.final_value(name) ==
            near(exact, 10 * tolerance * steps * (1 + std::abs(exact)) * (1 + reference->growth)));
    }
  }
  std::printf("%d of %d random scenes judged\n", judged, count);
  return judged;
}

}  // namespace

// Which scenes are drawn depends on the compiler that built the test; about a third of them can be judged.
TEST_CASE("random runs: two dozen scenes") { CHECK(judge_runs(24, 20040615) > 8); }
TEST_CASE("random runs: a thousand scenes", "[full]") { CHECK(judge_runs(1000, 20040616) > 300); }

}  // namespace mbcc::test
