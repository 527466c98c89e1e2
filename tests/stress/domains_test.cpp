// Functions whose domain a motion leaves. What must hold, with every method: the run fails (exit code 3) and names the
// force, its line, and the time; the rows until then are written.
//
// A particle comes from x = 0.5 at speed 1 to the end of its force's domain, x = 1, at t = 0.5 exactly.

#include "runs.hpp"

namespace mbcc::test {
namespace {

struct Edge {
  std::string particle;
  int line;
  bool includes_end;  ///< the force is defined at x = 1
};

const std::vector<Edge> edges = {{"arc", 6, true},    {"sine", 7, true},    {"ln_", 8, false},
                                 {"log_", 9, false},  {"root", 10, true},   {"power", 11, true},
                                 {"cosh_", 12, true}, {"tanh_", 13, false}, {"pole", 14, false}};

Run leave(const std::string& particle, std::vector<std::string> flags) {
  flags.insert(flags.end(), {"--to", "2", "--initial", particle + ".vx=1"});
  return run_model(stress_model("domains"), flags);
}

std::string message(const Edge& edge, double time) {
  char text[120];
  std::snprintf(text, sizeof text, "domains.mbd:%d: error: force on `%s`, y is not a finite number at t = %.9g",
                edge.line, edge.particle.c_str(), time);
  return text;
}

double time_in(const std::string& text) { return std::stod(text.substr(text.rfind("t = ") + 4)); }

void check_failed(const Run& run) {
  CHECK(run.exit_code == 3);
  CHECK(run.summary["status"] == "failed");
  CHECK(run.table.last("t") == run.final_value("t"));
  for (const std::vector<double>& column : run.table.columns) {
    CHECK(std::isfinite(column.back()));
  }
}

}  // namespace

TEST_CASE("domains: constant steps end at the first stage outside") {
  constexpr double step = 0.0625;  // a power of two: the end is met exactly
  for (const Edge& edge : edges) {
    const Run run = leave(edge.particle, {"--method", "rk4", "--step", flag(step)});
    check_failed(run);
    // Where the force is defined at the end, the stage in the middle of the next step is the first outside.
    CHECK(run.errors == message(edge, edge.includes_end ? 0.5 + step / 2 : 0.5) + "\n");
    CHECK(run.table.last("t") == (edge.includes_end ? 0.5 : 0.5 - step));
  }
}

TEST_CASE("domains: steps of the method's choice end at the edge itself") {
  for (const std::string& method : adaptive_methods) {
    // Steps become as short as the time resolves. Those of series go on while the polynomial is within its tolerance:
    // for (1 - x)^1.5, whose third derivative is the first to grow, some thousandths.
    const double reach = method == "dop853" ? 1e-11 : 0.005;
    for (const Edge& edge : edges) {
      INFO(edge.particle << " with " << method);
      const Run run = leave(edge.particle, {"--method", method});
      check_failed(run);
      CHECK(run.table.last("t") == near(0.5, reach));
      if (edge.particle == "pole") {  // finite on both sides
        CHECK(run.errors == "error: at t = 0.5 no step is short enough for `" +
                                (method == "dop853" ? std::string("pole.vy") : "pole.y") +
                                "` to stay within the tolerance 1e-09\n");
      } else {
        const double time = time_in(run.errors);
        CHECK(time >= 0.5);
        CHECK(time == near(0.5, reach));
        CHECK(run.errors == message(edge, time) + "\n");
      }
    }
  }
}

TEST_CASE("domains: a motion that overflows") {
  // vy = exp(1000 t)/1000 is beyond all numbers from t = 0.7167 on (ln(1.8e308) = 709.8, ln(1000) = 6.9).
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    std::vector<std::string> flags = {"--method", method};
    if (method == "rk4") {
      flags.insert(flags.end(), {"--step", "0.0625"});
    }
    const Run run = leave("steep", flags);
    check_failed(run);
    CHECK(run.errors.rfind("error: the motion grows without bound before t = 0.71", 0) == 0);
    CHECK(run.table.last("t") < 0.7167);
    CHECK(run.table.last("t") > 0.6);
  }
}

}  // namespace mbcc::test
