// The paper's example where its second particle loses a row.
//
// Its rows, z vx = vy and z^2 vx = vy, leave (z - z^2) vx = 0: where z is neither 0 nor 1 they hold vx = vy = 0, and
// since no force acts along x or y, nothing at all moves there: x2 and y2 keep their values to the last bit, whatever
// the step and however slowly z = 0 is passed. z2 = z0 + vz t has no force either: its error is that of the additions.
// The first particle shares no constraint with it and must not notice.

#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "runs.hpp"

namespace mbcc::test {
namespace {

/// The height of particle 1, which moves as a pendulum along the turning meridian.
double exact_height(double t) {
  double cn = 0, dn = 0;
  boost::math::jacobi_elliptic(std::sqrt(0.5), 8 * std::atan(1) * t, &cn, &dn);
  return std::sqrt(0.5) * cn / dn;
}

/// A passage of z = 0 in this way, from t = 0 to 5.
void check_passage(const std::string& method, double z0, double vz) {
  const double tolerance = 1e-12;
  std::vector<std::string> flags = {"--initial", "z2=" + flag(z0), "--initial", "vz2=" + flag(vz)};
  INFO(method << " from " << z0 << " at " << vz);
  const Run run = method == "rk4" ? completed(example_model("artigo5"), flags)
                                  : completed(example_model("artigo5"), method, tolerance, flags);
  const double steps = run.summary["steps"];
  CHECK(run.final_value("x2") == 2);
  CHECK(run.final_value("y2") == 1);
  CHECK(run.final_value("z2") == near(z0 + 5 * vz, eps * steps * (std::abs(z0) + 5 * vz)));
  CHECK(run.constraint_error("constraint_3", "velocity") == 0);
  CHECK(run.constraint_error("constraint_4", "velocity") == 0);
  // rk4: the method's error at the paper's step. Else: 1000 tolerances, as steps add up and a perturbation of the
  // motion grows tenfold in its five turns.
  CHECK(run.final_value("z1") == near(exact_height(5), method == "rk4" ? 3e-5 : 1000 * tolerance));
}

/// `vz` times the time of passage away from z = 0: on the paper's grid at t = 3, or between its points.
void check_passages(double vz) {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    check_passage(method, -3 * vz, vz);
    check_passage(method, -3.0012345 * vz, vz);
  }
}

}  // namespace

TEST_CASE("rank drop: passed on the grid and off it, as fast as in the paper and at a thousandth of that") {
  check_passages(0.25);
  check_passages(0.25e-3);
}

TEST_CASE("rank drop: passed in a hundred places at speeds down to 1e-6", "[full]") {
  for (const double speed : {0.25, 1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 25; ++i) {
      for (const std::string method : {"rk4", "dop853", "taylor"}) {
        check_passage(method, -(0.1 + 0.19371 * i) * speed, speed);
      }
    }
  }
}

TEST_CASE("rank drop: a start right at it goes on as if it were none") {
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    check_passage(method, 0, 0.25);
  }
}

TEST_CASE("rank drop: a motion that stays there is free along the row that is lost") {
  // At z = 0 both rows read vy = 0; x is free, and the speed that it has stays.
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    const Run run = completed(example_model("artigo5"),
                              {"--method", method, "--initial", "z2=0", "--initial", "vz2=0", "--initial", "vx2=0.5"});
    CHECK(run.final_value("x2") == near(4.5, 1e-12));  // a thousand additions to a number below 8
    CHECK(run.final_value("vx2") == 0.5);
    CHECK(run.final_value("y2") == 1);
    CHECK(run.summary["rank"]["minimum"] == 3);
  }
}

TEST_CASE("rank drop: a start there that no motion can leave is refused with both rows") {
  // Leaving z = 0 with vx != 0 the rows ask for ay = vz vx and for ay = 0.
  for (const std::string method : {"rk4", "dop853", "taylor"}) {
    const Run run =
        run_model(example_model("artigo5"), {"--method", method, "--initial", "z2=0", "--initial", "vx2=0.5"});
    CHECK(run.exit_code == 3);
    CHECK(run.errors ==
          "artigo5.mbd:20: error: no acceleration satisfies these constraints together at t = 0: `constraint_3` "
          "(artigo5.mbd:20, residual 0.0625), `constraint_4` (artigo5.mbd:21, residual -0.0625)\n");
    CHECK(run.table.rows() == 0);
  }
}

}  // namespace mbcc::test
