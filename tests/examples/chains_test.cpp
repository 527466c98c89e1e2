// Chains and rings of bobs made by loops: published end states and invariants.

#include <catch2/catch.hpp>

#include "example.hpp"

namespace mbcc::test {
namespace {

/// The chain with another number of links; structural, so the text is changed.
Run run_chain(const std::string& links) {
  std::string text = read_file(example("chain"));
  const std::string count = "constant N = 10";
  REQUIRE(text.find(count) != std::string::npos);
  text.replace(text.find(count), count.size(), "constant N = " + links);
  const ScratchDirectory scratch;
  write_file(scratch / "chain.mbd", text);
  Run run = run_model(scratch / "chain.mbd");
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  return run;
}

}  // namespace

TEST_CASE("chain: reference end states of three and ten links") {
  // References in quadruple precision; RK4's error at this step is below 1e-9 with three links, and grows with the
  // faster whirling of ten.
  const Table three = run_chain("3").table;
  CHECK(three.last("p[3].x") == near(2.1966081193683674, 1e-9));
  CHECK(three.last("p[3].y") == near(5.4394912265622523e-1, 1e-9));
  CHECK(three.last("p[3].z") == near(-1.8997075659265217, 1e-9));

  const Table ten = run_example("chain").table;
  CHECK(ten.last("p[10].x") == near(-7.5371994054581429, 1e-8));
  CHECK(ten.last("p[10].y") == near(-2.5705531392991957, 1e-8));
  CHECK(ten.last("p[10].z") == near(-5.933961553716337, 1e-8));
}

TEST_CASE("closed ring: energy and angular momentum about the vertical are kept") {
  const double drift = energy_drift("closed_ring", "0.0005");
  CHECK(observed_order(energy_drift("closed_ring", "0.001"), drift) == near(4, 0.1));
  CHECK(drift < 2e-7);  // of 215 J; what is left is RK4's, as its order shows
  const Table table = run_example("closed_ring").table;
  for (const double spin : table["spin"]) {
    REQUIRE(spin ==
            near(3 / std::sin(std::acos(-1.0) / 12), 1e-9));  // weight and pin have no moment about the vertical
  }
}

}  // namespace mbcc::test
