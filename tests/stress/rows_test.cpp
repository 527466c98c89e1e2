// One double pendulum, its constraints written in six ways. They describe one motion, and what a constraint is
// multiplied with, or how often it is said, must not be seen in it.

#include "runs.hpp"

namespace mbcc::test {
namespace {

/// The largest difference between the ends of pendulum i and of the first one.
double difference(const Run& run, int i) {
  double largest = 0;
  for (const std::string body : {"upper", "lower"}) {
    for (const std::string quantity : {"x", "y", "vx", "vy"}) {
      const auto end = [&](int k) { return run.final_value(body + "[" + std::to_string(k) + "]." + quantity); };
      largest = std::max(largest, std::abs(end(i) - end(1)));
    }
  }
  return largest;
}

void check_rows(const std::vector<std::string>& flags) {
  std::vector<std::string> all = {"--to", "10"};
  all.insert(all.end(), flags.begin(), flags.end());
  const Run run = completed(stress_model("rows"), all);

  // A swing of half a radian is regular: a perturbation grows with time, tenfold in its five periods. The rounding of
  // some 1e4 steps or evaluations, at random, is 1e2 eps.
  const double rounding = 1e4 * eps;
  CHECK(difference(run, 2) < rounding);
  CHECK(difference(run, 3) == 0);  // held when compiling: the same code
  CHECK(difference(run, 5) == 0);  // likewise
  CHECK(difference(run, 4) < rounding);
  CHECK(difference(run, 6) < rounding);

  // Errors in units of length do not depend on the factor either: a few roundings of a length of 1.
  for (const auto& [name, scale] : std::map<std::string, double>{{"plain_u", 1},
                                                                 {"scaled_u", 1e-8},
                                                                 {"scaled_l", 1e8},
                                                                 {"again_l", 1e8},
                                                                 {"square_l", 1e8},
                                                                 {"length_u", 1e-8}}) {
    INFO(name);
    CHECK(run.constraint_error(name, "position") < 8 * eps * scale);
  }

  // The row that is parallel to another one but for a part of 1e-9 is redundant, and watched: its error is that part,
  // 1e-9 (sin(0.5) - x) with x from -sin(0.5) to sin(0.5), all swings being as wide as the first at most.
  CHECK(run.constraint_error("nearly", "position") == near(2e-9 * std::sin(0.5), 1e-11));
  CHECK(run.summary["rank"]["minimum"] == 12);  // two for each pendulum
}

}  // namespace

TEST_CASE("rows: neither factors nor repetition change a motion") {
  check_rows({"--method", "rk4", "--step", "0.001", "--project", "on"});
  check_rows({"--method", "dop853", "--tolerance", "1e-12"});
}

TEST_CASE("rows: nor with series", "[full]") { check_rows({"--method", "taylor", "--tolerance", "1e-12"}); }

}  // namespace mbcc::test
