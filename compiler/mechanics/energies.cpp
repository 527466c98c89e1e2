#include "mechanics/energies.hpp"

#include "mechanics/collect.hpp"
#include "mechanics/directions.hpp"

namespace mbcc::mechanics {

namespace {

using graph::Graph;

class EnergyDifferentiation {
 public:
  EnergyDifferentiation(const Equations& equations, Graph& graph)
      : equations_(equations), motion_(equations.kinematics), graph_(graph) {
    terms_.inertia.resize(equations.inertia.size());
    terms_.forces.assign(equations.inertia.size(), graph.constant(0));
    for (std::size_t j = 0; j < equations.inertia.size(); ++j) {
      add_inertia(j, j, equations.inertia[j]);
    }
  }

  void add_kinetic(Expr kinetic) {
    for (const std::uint32_t speed : occurring(kinetic, Kind::Speed)) {
      add_momentum(partial(kinetic, Kind::Speed, speed), {{speed, graph_.constant(1)}});
    }
    for (const std::uint32_t i : occurring(kinetic, Kind::CoordinateRate)) {
      add_momentum(partial(kinetic, Kind::CoordinateRate, i), partials_along_speeds(equations_.kinematics[i]));
    }
    add_gradient(kinetic, 1);
  }

  /// What an energy adds along the coordinates that it depends on.
  void add_gradient(Expr energy, double sign) {
    for (const std::uint32_t i : occurring(energy, Kind::Coordinate)) {
      const Expr slope = substituted(partial(energy, Kind::Coordinate, i));
      for (const auto& [speed, direction] : partials_along_speeds(equations_.kinematics[i])) {
        Expr& force = terms_.forces[speed];
        force = sign > 0 ? force + direction * slope : force - direction * slope;
      }
    }
  }

  EnergyTerms take() {
    for (Expr& force : terms_.forces) {
      force = collect(force);
    }
    return std::move(terms_);
  }

 private:
  using BySpeed = std::map<std::size_t, Expr>;

  Expr substituted(Expr expression) const { return with_rates(expression, equations_.kinematics); }

  /// The time derivative of a momentum, along the speeds that move it.
  void add_momentum(Expr momentum, const BySpeed& directions) {
    const Expr p = substituted(momentum);
    const BySpeed inertia = partials_along_speeds(p);
    const Expr rest = motion_.rate(p);
    for (const auto& [speed, direction] : directions) {
      terms_.forces[speed] = terms_.forces[speed] - direction * rest;
      for (const auto& [other, value] : inertia) {
        add_inertia(speed, other, direction * value);
      }
    }
  }

  void add_inertia(std::size_t row, std::size_t column, Expr value) {
    if (!is_zero(value)) {
      const auto [entry, is_new] = terms_.inertia[row].try_emplace(column, value);
      if (!is_new) {
        entry->second = entry->second + value;
      }
    }
  }

  const Equations& equations_;
  const UnacceleratedMotion motion_;
  Graph& graph_;
  EnergyTerms terms_;
};

}  // namespace

EnergyTerms differentiate_energies(const Equations& equations, Graph& graph) {
  EnergyDifferentiation differentiation(equations, graph);
  for (const Expr kinetic : equations.kinetic) {
    differentiation.add_kinetic(kinetic);
  }
  for (const Expr potential : equations.potential) {
    differentiation.add_gradient(potential, -1);
  }
  return differentiation.take();
}

}  // namespace mbcc::mechanics
