// Islands, elimination orders, dependence, and rows that are held.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>

#include "mechanics/dependence.hpp"
#include "mechanics/eliminate.hpp"
#include "mechanics/islands.hpp"
#include "support/compiled.hpp"
#include "support/random_scene.hpp"
#include "support/scenes.hpp"

namespace mbcc::mechanics {
namespace {

using test::Random;

Derivatives derivatives_of(const std::string& text) { return test::compiled(text, Stage::Derivatives).derivatives; }

/// Nonzeros of L below its diagonal when `order` is the order of elimination of A A^T.
std::size_t fill_of(const std::vector<Row>& rows, const std::vector<std::size_t>& order) {
  const std::size_t n = order.size();
  std::vector<std::vector<bool>> pattern(n, std::vector<bool>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (const Entry& a : rows[order[i]].entries) {
        for (const Entry& b : rows[order[j]].entries) {
          pattern[i][j] = pattern[i][j] || a.speed == b.speed;
        }
      }
    }
  }
  std::size_t nonzeros = 0;
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = k + 1; i < n; ++i) {
      nonzeros += pattern[i][k] ? 1U : 0U;
      for (std::size_t j = k + 1; j < i && pattern[i][k]; ++j) {
        pattern[i][j] = pattern[i][j] || pattern[j][k];
      }
    }
  }
  return nonzeros;
}

/// The numbers of the equation at one state, dense.
struct Dense {
  Eigen::MatrixXd a;
  Eigen::VectorXd b, free, mobility;
};

Dense dense(const Island& island, const Derivatives& derivatives, const Point& point) {
  const auto rows = static_cast<Eigen::Index>(island.rows.size());
  const auto columns = static_cast<Eigen::Index>(island.speeds.size());
  Dense d{Eigen::MatrixXd::Zero(rows, columns), Eigen::VectorXd(rows), Eigen::VectorXd(columns),
          Eigen::VectorXd(columns)};
  for (Eigen::Index k = 0; k < rows; ++k) {
    const Row& row = derivatives.rows[island.rows[static_cast<std::size_t>(k)]];
    d.b[k] = value_at(point, row.b);
    for (const Entry& entry : row.entries) {
      const auto column = std::find(island.speeds.begin(), island.speeds.end(), entry.speed) - island.speeds.begin();
      d.a(k, column) = value_at(point, entry.value);
    }
  }
  for (Eigen::Index j = 0; j < columns; ++j) {
    d.free[j] = value_at(point, derivatives.free[island.speeds[static_cast<std::size_t>(j)]]);
    d.mobility[j] = value_at(point, derivatives.mobility[island.speeds[static_cast<std::size_t>(j)]]);
  }
  return d;
}

}  // namespace

TEST_CASE("elimination solves what a dense factorisation solves") {
  Random random(3);
  int judged = 0;
  for (int scene = 0; scene < 200; ++scene) {
    Compilation c = compile("scene.mbd", test::RandomScene(random).text(), {false, Stage::Derivatives});
    if (c.diagnostics.has_errors()) {
      continue;
    }
    const Point start = initial_point(*c.system, c.equations);
    for (const Island& island : c.derivatives.islands) {
      const Dense d = dense(island, c.derivatives, start);
      const Eigen::MatrixXd scaled = d.a.rowwise().norm().cwiseInverse().asDiagonal() * d.a;
      const Eigen::MatrixXd b = scaled * d.mobility.cwiseSqrt().asDiagonal();
      const Eigen::VectorXd sigma = b.jacobiSvd().singularValues();
      const double condition = sigma[0] / sigma[sigma.size() - 1];
      if (b.rows() > b.cols() || !(condition < 1e3)) {
        continue;
      }
      ++judged;
      const Eigen::VectorXd z = (d.a * d.mobility.asDiagonal() * d.a.transpose()).ldlt().solve(d.b - d.a * d.free);
      const Eigen::VectorXd expected = d.free + d.mobility.asDiagonal() * d.a.transpose() * z;
      const std::vector<double> got = values_at(start, eliminate(island, c.derivatives, *c.graph).accelerations);
      REQUIRE(got.size() == island.speeds.size());
      INFO(c.sources[0].text());
      for (std::size_t j = 0; j < got.size(); ++j) {
        // Both square the condition: 1e-16 * 1e6, with a factor for the cancellation of a and what is added.
        CHECK(std::abs(got[j] - expected[static_cast<Eigen::Index>(j)]) < 1e-8 * std::max(1.0, expected.norm()));
      }
    }
  }
  CHECK(judged > 100);
}

TEST_CASE("independent copies are islands of their own, in the order of their first rows") {
  const Derivatives derivatives = derivatives_of(R"(dimension 1
particle 1 { mass = 1; position = 1 }
particle 2 { mass = 1; position = 1 }
particle 3 { mass = 1; position = 1 }
particle 4 { mass = 1; position = 1 }
constraint : x3*x4 = 1
constraint : x1*x2 = 1
)");
  REQUIRE(derivatives.islands.size() == 2);
  CHECK(derivatives.islands[0].rows == std::vector<std::size_t>{0});
  CHECK(derivatives.islands[0].speeds == std::vector<std::size_t>{2, 3});
  CHECK(derivatives.islands[1].speeds == std::vector<std::size_t>{0, 1});
}

TEST_CASE("bodies that act on each other by forces alone are no island") {
  CHECK(derivatives_of(test::cluster(3)).islands.empty());
}

TEST_CASE("a chain is one island that fills in nothing, or half a chain where it is long") {
  for (const int links : {2, 10, 32, 33, 50}) {
    const Derivatives derivatives = derivatives_of(test::chain(links));
    REQUIRE(derivatives.islands.size() == 1);
    const std::vector<std::size_t>& order = derivatives.islands[0].rows;
    const auto couplings = static_cast<std::size_t>(links - 1);
    if (links < 33) {
      CHECK(fill_of(derivatives.rows, order) == couplings);
    } else {  // rows 1, 3, 5 ... first: each joins its two neighbours
      const auto apart = couplings / 2;
      for (std::size_t k = 0; k < apart; ++k) {
        CHECK(order[k] == 2 * k + 1);
      }
      CHECK(fill_of(derivatives.rows, order) == couplings + apart);
    }
  }
}

TEST_CASE("a row that touches all others is eliminated last") {
  const std::string text = R"(dimension 1
constant N = 12
for i in 1..N { particle p[i] { mass = 1; position = i } }
constraint hub : sum(i in 1..N, p[i].x^2) = 650
for i in 1..N - 1 { constraint k[i] : sin(p[i].x) = sin(i) }
)";
  const Derivatives derivatives = derivatives_of(text);
  REQUIRE(derivatives.islands.size() == 1);
  const Island& island = derivatives.islands[0];
  CHECK((island.rows.back() == 0 || island.rows[island.rows.size() - 2] == 0));  // with one other left it is the same
  CHECK(fill_of(derivatives.rows, island.rows) == 11);
  std::vector<std::size_t> hub_first(island.rows.size());
  for (std::size_t k = 0; k < hub_first.size(); ++k) {
    hub_first[k] = k;
  }
  CHECK(fill_of(derivatives.rows, hub_first) == 66);  // what it would cost
}

TEST_CASE("rows that others imply are held, whatever their factors") {
  const std::string scene = R"(dimension 2
particle 1 { mass = 1; position = (1, 0) }
particle 2 { mass = 3; position = (2, 0) }
constraint a : x1^2 + y1^2 = 1
constraint b : (x2 - x1)^2 + (y2 - y1)^2 = 1
)";
  const auto held = [&](const std::string& more) {
    const Derivatives derivatives = derivatives_of(scene + more);
    REQUIRE(derivatives.islands.size() == 1);
    return derivatives.islands[0].held;
  };
  CHECK(held("").empty());
  CHECK(held("constraint c : x1^2 + y1^2 = 1\n") == std::vector<std::size_t>{2});
  CHECK(held("constraint c : 1e-8*(x1^2 + y1^2 - 1) = 0\n") == std::vector<std::size_t>{2});
  CHECK(held("constraint c : x1^2 + y1^2 + (x2 - x1)^2 + (y2 - y1)^2 = 2\n") == std::vector<std::size_t>{2});
  CHECK(held("constraint c : x1*vx1 + y1*vy1 = 0\n") == std::vector<std::size_t>{2});
  CHECK(held("constraint c : x1^2 + y1^2 + max(t - 1, 0)^3 = 1\n").empty());         // the same near the start alone
  CHECK(held("constraint c : norm((x1, y1)) = 1\n").empty());                        // with a factor that varies
  CHECK(held("constraint c : x1^2 + 2*y1^2 = 1\n").empty());                         // at the start alone
  CHECK(held("constraint c : x1^2 + y1^2 + 1e-6*((x2 - 2)^2 + y2) = 1\n").empty());  // nearly
}

TEST_CASE("a row stays that would leave nearly parallel ones behind") {
  const Derivatives derivatives = derivatives_of(R"(dimension 1
particle 1 { mass = 1; position = 1 }
particle 2 { mass = 1; position = 1 }
particle 3 { mass = 1; position = 1 }
constraint a : x1*x2 = 1
constraint b : x1*x2 + 1e-5*(x2 - x3) = 1
constraint c : x2 = x3
)");
  CHECK(derivatives.islands[0].held.empty());
}

TEST_CASE("dependences name the rows that a row is made of, and how") {
  const Compilation c = test::compiled(R"(dimension 1
particle 1 { mass = 4; position = 0 }
particle 2 { mass = 9; position = 0 }
particle 3 { mass = 1; position = 0 }
constraint a : x1 + x2 = 0
constraint b : 1e6*(x2 - x3) = 0
constraint c : x1 + 3*x3 = 0
)");
  const Island& island = c.derivatives.islands[0];
  const std::vector<Dependence> found = find_dependences(island, c.derivatives, initial_point(*c.system, c.equations));
  REQUIRE(found.empty());

  const Compilation d = test::compiled(R"(dimension 1
particle 1 { mass = 4; position = 0 }
particle 2 { mass = 9; position = 0 }
particle 3 { mass = 1; position = 0 }
constraint a : x1 + x2 = 0
constraint b : 1e6*(x2 - x3) = 0
constraint c : x1 + 3*x3 = 0
constraint d : x1 + 3*x3 + 7*(x1 + x2) - 1e-6*(1e6*(x2 - x3)) = 0
)");
  const std::vector<Dependence> of_d =
      find_dependences(d.derivatives.islands[0], d.derivatives, initial_point(*d.system, d.equations));
  REQUIRE(of_d.size() == 1);
  CHECK(of_d[0].row == 3);
  REQUIRE(of_d[0].on.size() == 3);
  const std::array expected = {7.0, -1e-6, 1.0};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(of_d[0].on[k].first == k);
    // A solve of well-conditioned rows of size 1: a few roundings.
    CHECK(of_d[0].on[k].second == Approx(expected[k]).epsilon(1e-12));
  }
}

}  // namespace mbcc::mechanics
