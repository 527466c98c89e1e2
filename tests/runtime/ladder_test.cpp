// The rank ladder against a pinv in quadruple precision.

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "allocations.hpp"
#include "mbrt/island.hpp"
#include "quad_pinv.hpp"
#include "random_island.hpp"

using namespace mbrt;
using namespace mbrt::test;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

Eigen::VectorXd climb_from(DynamicIsland& island, const Rows& rows) {
  fill(island, rows);
  Eigen::VectorXd added(rows.a.cols());
  climb(island.view(), {added.data(), static_cast<std::size_t>(added.size())});
  return added;
}

DynamicIsland started(const Rows& rows) {
  DynamicIsland island(static_cast<std::size_t>(rows.a.rows()), static_cast<std::size_t>(rows.a.cols()));
  fill(island, rows);
  take_scales(island.view());
  return island;
}

/// The scaled problem B w = D r in quadruple precision, from the same doubles that `climb` reads.
Truncated oracle(const DynamicIsland& island, const Rows& rows, double cutoff = default_cutoff) {
  QuadMatrix b;
  std::vector<Quad> r;
  for (Eigen::Index i = 0; i < rows.a.rows(); ++i) {
    const Quad scale = island.scale[static_cast<std::size_t>(i)];
    r.push_back(scale * rows.r(i));
    b.emplace_back();
    for (Eigen::Index j = 0; j < rows.a.cols(); ++j) {
      b.back().push_back(scale * rows.a(i, j) * sqrt(Quad(rows.mobility(j))));
    }
  }
  return truncated_pinv(b, r, cutoff);
}

double condition(const Truncated& solution) { return static_cast<double>(solution.largest / solution.smallest_kept); }

/// Whether a singular value is so near the cut-off that two correct programs may decide differently.
bool ambiguous(const Truncated& solution) {
  const Quad cut = default_cutoff * std::max(solution.largest, Quad(1));
  return solution.largest_dropped > cut / 10 || solution.smallest_kept < cut * 10;
}

/// A right-hand side that some acceleration of ordinary size reaches.
void make_reachable(Rows& rows, RandomRows& random) {
  rows.r = rows.a * (rows.mobility.cwiseSqrt().asDiagonal() * random.normal(rows.a.cols(), 1));
}

/// Makes the last `count` rows combinations of the others, off by about `distance`.
void make_dependent(Rows& rows, Eigen::Index count, double distance, RandomRows& random) {
  const Eigen::Index kept = rows.a.rows() - count;
  const Eigen::MatrixXd off = distance * random.normal(count, rows.a.cols());
  rows.a.bottomRows(count) =
      random.normal(count, kept) * rows.a.topRows(kept) + off * rows.mobility.cwiseSqrt().cwiseInverse().asDiagonal();
}

Rows permuted(const Rows& rows, RandomRows& random) {
  Eigen::PermutationMatrix<Eigen::Dynamic> order(rows.a.rows());
  order.setIdentity();
  for (int i = static_cast<int>(rows.a.rows()) - 1; i > 0; --i) {
    order.applyTranspositionOnTheRight(i, random.integer(0, i));
  }
  return {order * rows.a, order * rows.r, rows.mobility};
}

Rows rescaled(Rows rows, RandomRows& random) {
  for (Eigen::Index i = 0; i < rows.a.rows(); ++i) {
    const double factor = std::pow(10, random.uniform(-8, 8));
    rows.a.row(i) *= factor;
    rows.r(i) *= factor;
  }
  return rows;
}

/// |M^1/2 (c - expected)| / |M^1/2 expected|.
double relative_error(const Rows& rows, const Eigen::VectorXd& c, const std::vector<Quad>& w) {
  Quad difference = 0, size = 0;
  for (Eigen::Index j = 0; j < c.size(); ++j) {
    const Quad expected = w[static_cast<std::size_t>(j)];
    const Quad d = c(j) / sqrt(Quad(rows.mobility(j))) - expected;
    difference += d * d;
    size += expected * expected;
  }
  return static_cast<double>(sqrt(difference / size));
}

}  // namespace

TEST_CASE("the ladder is accurate up to a condition of 1e7") {
  RandomRows random(1);
  long refined = 0, pinv = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const int count = random.integer(1, 8);
    const int columns = random.integer(std::max(3, count), 24);
    Rows rows = random.rows(count, columns, std::pow(10, random.uniform(0, 7)));
    if (trial % 2 == 0) {
      make_reachable(rows, random);
    }
    DynamicIsland island = started(rows);
    const Truncated expected = oracle(island, rows);
    const Eigen::VectorXd c = climb_from(island, rows);
    CAPTURE(trial, count, columns, condition(expected));
    REQUIRE(relative_error(rows, c, expected.solution) < 100 * eps * condition(expected));
    REQUIRE(island.record.rank == count);
    REQUIRE(island.record.unreachable < 100 * eps * condition(expected));
    refined += island.record.refined;
    pinv += island.record.pinv;
  }
  CHECK(refined > 500);  // both steps were judged
  CHECK(pinv > 500);
}

TEST_CASE("refinement is accurate right up to the pivot ratio where it ends") {
  // Two rows at a small angle have the pivot ratio sin^2 of it: from 1e-4 down to 1e-9.
  RandomRows random(2);
  for (int trial = 0; trial < 500; ++trial) {
    Rows rows = random.rows(2, random.integer(3, 24), 1);
    const double sine = std::pow(10, random.uniform(-4.45, -2));
    const double cosine = std::sqrt(1 - sine * sine);
    rows.a.row(1) = cosine * rows.a.row(0) + sine * rows.a.row(1);
    make_reachable(rows, random);
    DynamicIsland island = started(rows);
    const Truncated expected = oracle(island, rows);
    const Eigen::VectorXd c = climb_from(island, rows);
    CAPTURE(trial, sine);
    REQUIRE(island.record.refined == 1);
    REQUIRE(relative_error(rows, c, expected.solution) < 100 * eps * condition(expected));
  }
}

TEST_CASE("dependent rows give the truncated pinv, to first order in what is dropped") {
  RandomRows random(3);
  int judged = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const int count = random.integer(2, 8);
    const int dependent = random.integer(1, count - 1);
    Rows rows = random.rows(count, random.integer(3, 24), std::pow(10, random.uniform(0, 3)));
    make_dependent(rows, dependent, trial % 2 == 0 ? 0 : std::pow(10, random.uniform(-14, -9)), random);
    make_reachable(rows, random);
    DynamicIsland island = started(rows);
    const Truncated expected = oracle(island, rows);
    if (ambiguous(expected)) {
      continue;
    }
    ++judged;
    const Eigen::VectorXd c = climb_from(island, rows);
    const double dropped = static_cast<double>(expected.largest_dropped / expected.smallest_kept);
    CAPTURE(trial, count, dependent, condition(expected), dropped);
    REQUIRE(island.record.rank == static_cast<int>(expected.rank));
    // The two subspaces differ by an angle of the order of `dropped`, and r weighs in with up to the condition.
    REQUIRE(relative_error(rows, c, expected.solution) < (100 * eps + 10 * dropped) * condition(expected));
  }
  CHECK(judged > 1500);
}

TEST_CASE("neither the order of rows nor a factor on a row matters") {
  RandomRows random(4);
  for (int trial = 0; trial < 1000; ++trial) {
    const int count = random.integer(2, 8);
    Rows rows = random.rows(count, random.integer(8, 24), std::pow(10, random.uniform(0, 6)));
    if (trial % 2 == 0) {
      make_dependent(rows, random.integer(1, count - 1), 0, random);
      make_reachable(rows, random);
    }
    DynamicIsland island = started(rows);
    const Truncated expected = oracle(island, rows);
    if (ambiguous(expected)) {
      continue;
    }
    const Rows other = rescaled(permuted(rows, random), random);
    DynamicIsland other_island = started(other);
    const Eigen::VectorXd c = climb_from(island, rows);
    const Eigen::VectorXd d = climb_from(other_island, other);
    CAPTURE(trial, count, condition(expected));
    REQUIRE(island.record.rank == other_island.record.rank);
    REQUIRE(relative_error(rows, c, expected.solution) < 100 * eps * condition(expected));
    REQUIRE(relative_error(rows, d, expected.solution) < 100 * eps * condition(expected));
  }
}

TEST_CASE("more rows than speeds") {
  RandomRows random(5);
  for (int trial = 0; trial < 200; ++trial) {
    Rows rows = random.rows(8, random.integer(1, 7), 10);
    make_reachable(rows, random);
    DynamicIsland island = started(rows);
    const Truncated expected = oracle(island, rows);
    const Eigen::VectorXd c = climb_from(island, rows);
    REQUIRE(island.record.rank == rows.a.cols());
    REQUIRE(relative_error(rows, c, expected.solution) < 100 * eps * condition(expected));
  }
}

TEST_CASE("no residual adds no acceleration at all") {
  RandomRows random(6);
  for (const int dependent : {0, 2}) {
    Rows rows = random.rows(4, 9, 100);
    make_dependent(rows, dependent, 0, random);
    rows.r.setZero();
    DynamicIsland island = started(rows);
    CHECK((climb_from(island, rows).array() == 0).all());
    CHECK(island.record.unreachable == 0);
    CHECK(island.record.pinv == (dependent > 0 ? 1 : 0));
  }
}

TEST_CASE("what no acceleration reaches is measured") {
  const double third = 1.0 / 3;
  Rows rows{Eigen::MatrixXd::Ones(2, 1), Eigen::Vector2d(6, 12), Eigen::VectorXd::Constant(1, third)};
  DynamicIsland island = started(rows);
  const Eigen::VectorXd c = climb_from(island, rows);
  CHECK(c(0) == Approx(9).epsilon(10 * eps));  // the mean; a few roundings
  CHECK(island.record.rank == 1);
  CHECK(island.record.unreachable == Approx(std::sqrt(0.1)).epsilon(10 * eps));  // |(-3, 3)| / |(6, 12)|
}

TEST_CASE("a row that shrinks counts until it reaches the cut-off, and then no more") {
  Rows rows{Eigen::RowVector3d(3, 0, 4), Eigen::VectorXd::Ones(1), Eigen::Vector3d(1, 1, 1)};
  DynamicIsland island = started(rows);
  const Rows start = rows;
  for (const double size : {1e-3, 1e-6, 1e-7, 2e-8}) {
    rows.a = size * start.a;
    const Eigen::VectorXd c = climb_from(island, rows);
    CAPTURE(size);
    CHECK((c * size - Eigen::Vector3d(0.12, 0, 0.16)).norm() < 10 * eps);
    CHECK(island.record.rank == 1);
  }
  rows.a = 0.5e-8 * start.a;
  CHECK((climb_from(island, rows).array() == 0).all());
  CHECK(island.record.rank == 0);
}

TEST_CASE("the cut-off is a setting that every step respects") {
  Rows rows{Eigen::Matrix2d{{1, 0}, {1, 1e-4}}, Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 1)};
  DynamicIsland island = started(rows);
  climb_from(island, rows);
  CHECK(island.record.refined == 1);
  CHECK(island.record.rank == 2);
  island.record.cutoff = largest_cutoff;
  climb_from(island, rows);
  CHECK(island.record.pinv == 1);
  CHECK(island.record.rank == 1);

  const Rows single{Eigen::RowVector2d(3, 4), Eigen::VectorXd::Ones(1), Eigen::Vector2d(1, 1)};
  DynamicIsland alone(1, 2);
  alone.record.cutoff = largest_cutoff;
  fill(alone, single);
  take_scales(alone.view());
  // Step 1 must let go of the row before it is a thousandth of itself, S_kk a millionth.
  CHECK(alone.floor[0] > largest_cutoff * largest_cutoff * 25);
}

TEST_CASE("what is not finite is passed on") {
  Rows rows{Eigen::Matrix2d{{1, 0}, {std::nan(""), 1}}, Eigen::Vector2d(1, 1), Eigen::Vector2d(1, 1)};
  DynamicIsland island(2, 2);
  CHECK(climb_from(island, rows).array().isNaN().all());
  rows.a(1, 0) = 0;
  rows.r(0) = std::numeric_limits<double>::infinity();
  CHECK(climb_from(island, rows).array().isNaN().all());
}

TEST_CASE("scales are the sizes of rows, and vanishing rows keep the scale they had") {
  Rows rows{Eigen::MatrixXd{{3e-9, 4e-9}, {0, 0}, {3, 4}}, Eigen::Vector3d(0, 0, 0), Eigen::Vector2d(4, 4)};
  DynamicIsland island(3, 2);
  fill(island, rows);
  CHECK(take_scales(island.view()) == 1);
  CHECK(island.scale[0] == Approx(1e8).epsilon(10 * eps));
  CHECK(island.scale[1] == 1);
  CHECK(island.scale[2] == Approx(0.1).epsilon(10 * eps));
  CHECK(island.floor[2] == Approx(vanishing_ratio * 100).epsilon(10 * eps));
  rows.a << 3e-17, 4e-17, 1, 0, 6, 8;
  fill(island, rows);
  CHECK(take_scales(island.view()) == 1);
  CHECK(island.scale[0] == Approx(1e8).epsilon(10 * eps));
  CHECK(island.scale[1] == Approx(0.5).epsilon(10 * eps));
  CHECK(island.scale[2] == Approx(0.05).epsilon(10 * eps));
}

TEST_CASE("no step of the ladder allocates") {
  RandomRows random(7);
  for (const int dependent : {0, 3}) {
    Rows rows = random.rows(30, 90, 10);
    make_dependent(rows, dependent, 0, random);
    DynamicIsland island = started(rows);
    Eigen::VectorXd added(90);
    fill(island, rows);
    const long before = allocations();
    climb(island.view(), {added.data(), 90});
    CHECK(allocations() == before);
    CHECK(island.record.rank == 30 - dependent);
  }
}
