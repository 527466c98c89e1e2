// Inertia that couples speeds: accelerations against the dense equations [M A^T; A 0], which need no elimination and no
// inertia for every speed.

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "mechanics/directions.hpp"
#include "mechanics/eliminate.hpp"
#include "mechanics/energies.hpp"
#include "mechanics/point.hpp"
#include "mechanics/uncouple.hpp"
#include "support/compiled.hpp"

namespace mbcc {
namespace {

using mechanics::Derivatives;
using mechanics::Expr;
using mechanics::Point;

/// u' as the emitted code has it.
std::vector<Expr> accelerations(const Derivatives& derivatives, graph::Graph& graph) {
  std::vector<Expr> result = derivatives.free;
  for (const mechanics::Island& island : derivatives.islands) {
    const mechanics::Elimination elimination = eliminate(island, derivatives, graph);
    for (std::size_t j = 0; j < island.speeds.size(); ++j) {
      result[island.speeds[j]] = elimination.accelerations[j];
    }
  }
  return result;
}

/// u' of M u' - A^T z = f, A u' = b.
Eigen::VectorXd dense_accelerations(const Compilation& c, const Point& point) {
  const mechanics::EnergyTerms energies = differentiate_energies(c.equations, *c.graph);
  const auto speeds = static_cast<Eigen::Index>(c.system->speeds.size());
  const auto rows = static_cast<Eigen::Index>(c.derivatives.rows.size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(speeds + rows, speeds + rows);
  Eigen::VectorXd right(speeds + rows);
  for (Eigen::Index j = 0; j < speeds; ++j) {
    for (const auto& [i, value] : energies.inertia[static_cast<std::size_t>(j)]) {
      matrix(j, static_cast<Eigen::Index>(i)) = value_at(point, value);
    }
    right[j] = value_at(point, energies.forces[static_cast<std::size_t>(j)]);
  }
  for (std::size_t i = 0; i < c.equations.forces.size(); ++i) {
    for (const auto& [j, direction] : mechanics::partials_along_speeds(c.equations.force_velocities[i])) {
      right[static_cast<Eigen::Index>(j)] += value_at(point, direction) * value_at(point, c.equations.forces[i]);
    }
  }
  for (Eigen::Index k = 0; k < rows; ++k) {
    const mechanics::Row& row = c.derivatives.rows[static_cast<std::size_t>(k)];
    for (const mechanics::Entry& entry : row.entries) {
      const auto j = static_cast<Eigen::Index>(entry.speed);
      matrix(speeds + k, j) = value_at(point, entry.value);
      matrix(j, speeds + k) = -matrix(speeds + k, j);
    }
    right[speeds + k] = value_at(point, row.b);
  }
  return matrix.fullPivLu().solve(right).head(speeds);
}

/// Largest difference at the start, relative to the largest acceleration.
double difference(const std::string& model) {
  const Compilation c = test::compiled(model, Stage::Derivatives);
  const Point start = initial_point(*c.system, c.equations);
  const Eigen::VectorXd expected = dense_accelerations(c, start);
  const std::vector<double> found = values_at(start, accelerations(c.derivatives, *c.graph));
  return (Eigen::Map<const Eigen::VectorXd>(found.data(), expected.size()) - expected).cwiseAbs().maxCoeff() /
         expected.cwiseAbs().maxCoeff();
}

/// Three links hanging from each other, by their angles, the end on a track.
const std::string links =
    "dimension 2\n"
    "coordinate a { value = 0.3; rate = 1 }\n"
    "coordinate b { value = 0.9; rate = -0.7 }\n"
    "coordinate c { value = 1.4; rate = 0.2 }\n"
    "let p = (sin(a), -cos(a))\n"
    "let q = p + (sin(b), -cos(b))\n"
    "let r = q + (sin(c), -cos(c))\n"
    "kinetic 0.5*dot(p', p') + dot(q', q') + 1.5*dot(r', r')\n"
    "potential 9.81*(p.y + 2*q.y + 3*r.y)\n";

// The matrices are of size one and their condition below a hundred.
constexpr double rounding = 1e-12;

TEST_CASE("coupled inertia without constraints") { CHECK(difference(links) < rounding); }

TEST_CASE("coupled inertia with constraints: one, two, and as many as speeds") {
  const std::string track = links +
                            "constraint : r.y + 0.1*r.x^2 = -cos(0.3) - cos(0.9) - cos(1.4) + "
                            "0.1*(sin(0.3) + sin(0.9) + sin(1.4))^2\n";
  // Speeds at the start need not satisfy the constraints: the equations are the same.
  const auto at_any_speed = [](const std::string& model) {
    const Compilation c = compile("model.mbd", model, {false, Stage::Derivatives, true});
    const Point start = initial_point(*c.system, c.equations);
    const Eigen::VectorXd expected = dense_accelerations(c, start);
    const std::vector<double> found = values_at(start, accelerations(c.derivatives, *c.graph));
    return (Eigen::Map<const Eigen::VectorXd>(found.data(), expected.size()) - expected).norm() / expected.norm();
  };
  CHECK(at_any_speed(track) < rounding);
  CHECK(at_any_speed(track + "constraint : a' = 2*c'^2\n") < rounding);
  CHECK(at_any_speed(track + "constraint : a' = 2*c'^2\nconstraint : sin(b) = p.x + 0.1*c\n") < rounding);
}

TEST_CASE("speeds without inertia: one, and one that needs another") {
  const std::string defined = links + "speed s { value = -0.7 + 0.2 }\nforce on s = 0.4\nconstraint : s = b' + c'\n";
  CHECK(difference(defined) < rounding);
  CHECK(difference(defined + "speed t2 { value = 0.25 }\nforce on t2 = -0.3\nconstraint : t2 = s^2\n") < rounding);
}

TEST_CASE("kinematics: more coordinates than speeds, bound by a holonomic constraint") {
  CHECK(difference("coordinate x { value = 0 }\n"
                   "coordinate y { value = 0 }\n"
                   "coordinate angle { value = 0.4; rate = 2*sin(0.4) }\n"
                   "speed v { value = 1 }\n"
                   "kinematics x' = v*cos(angle)\n"
                   "kinematics y' = v*sin(angle)\n"
                   "kinetic x'^2 + y'^2 + 0.5*angle'^2 + 0.2*x'*angle'\n"
                   "force on x = 1 - y\n"
                   "constraint : y + x^2 = 0.5*angle - 0.2\n") < rounding);
}

}  // namespace
}  // namespace mbcc
