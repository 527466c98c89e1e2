// Constraints that no motion satisfies: named with their lines, exit code 3, and no state that violates them unseen.

#include "runs.hpp"

namespace mbcc::test {

// x'' = 0 and x'' = 6(t - 1) differ by 6(t - 1) behind t = 1: the first state that is looked at there shows it, as soon
// as that is above a millionth of the terms (failures.hpp).
TEST_CASE("contradiction: found where it begins, with both names") {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    INFO(method);
    std::vector<std::string> flags = {"--method", method, "--to", "3"};
    if (method == "rk4") {
      flags.insert(flags.end(), {"--step", "0.03125"});
    }
    const Run run = run_model(stress_model("contradiction"), flags);
    CHECK(run.exit_code == 3);
    CHECK(run.summary["status"] == "failed");
    CHECK(run.errors.find("contradiction.mbd:6: error: no acceleration satisfies these constraints together at t = ") !=
          std::string::npos);
    CHECK(run.errors.find("`even` (contradiction.mbd:6, residual ") != std::string::npos);
    CHECK(run.errors.find("`hurried` (contradiction.mbd:7, residual ") != std::string::npos);
    CHECK(run.table.last("t") <= 1.2);
    CHECK(run.table.last("bead.x") == run.table.last("t"));
  }
}

}  // namespace mbcc::test
