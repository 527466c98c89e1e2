#include "precision/by_hand.hpp"

#include <memory>

#include "expert/chain.hpp"
#include "expert/chain_series.hpp"
#include "expert/linkages.hpp"
#include "expert/orbits.hpp"
#include "expert/paper_example.hpp"
#include "precision/hung_chain.hpp"
#include "precision/odeint.hpp"

namespace bench::precision {

namespace {

template <class Model>
std::vector<Contender> explicit_methods(const SecondOrder<Model>& scene) {
  return {with_pair<expert::Dop853>("expert, dop853", scene), with_pair<expert::Rkf78>("expert, rkf78", scene),
          with_rk4("expert, rk4", scene), with_odeint("Boost.Odeint, rkf78", scene)};
}

/// x of all masses, then y, then z, `Width` apart; a held end is one mass more.
template <std::size_t Links, std::size_t Width, bool IsHeld>
SecondOrder<expert::Chain<Links, Width, IsHeld>> axis_by_axis(const HungChain& chain) {
  SecondOrder<expert::Chain<Links, Width, IsHeld>> scene{{}, {}, {}, chain.to};
  const auto put = [&](std::size_t mass, const std::array<double, 3>& position, const std::array<double, 3>& velocity) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      scene.start.q[axis * Width + mass] = position[axis];
      scene.start.v[axis * Width + mass] = velocity[axis];
    }
  };
  for (std::size_t mass = 0; mass < chain.masses.size(); ++mass) {
    put(mass, chain.masses[mass].position, chain.masses[mass].velocity);
  }
  if (chain.far_end) {
    put(Links - 1, *chain.far_end, {});
  }
  for (const HungChain::Watched& watched : chain.watched) {
    scene.places.push_back(watched.axis * Width + watched.mass);
  }
  return scene;
}

template <std::size_t Links, bool IsHeld = false>
Contender series(const HungChain& chain) {
  std::vector<double> start(6 * Links);
  for (std::size_t j = 0; j < 3 * chain.masses.size(); ++j) {
    start[j] = chain.masses[j / 3].position[j % 3];
    start[3 * Links + j] = chain.masses[j / 3].velocity[j % 3];
  }
  for (std::size_t axis = 0; chain.far_end && axis < 3; ++axis) {
    start[3 * Links - 3 + axis] = (*chain.far_end)[axis];
  }
  const auto integrator = std::make_shared<expert::ChainSeries<Links, IsHeld>>();
  return {"expert, taylor", tolerances(), [integrator, start, chain](double tolerance) {
            const std::vector<double> end = integrator->integrate(start, chain.to, tolerance);
            std::vector<double> watched;
            for (const HungChain::Watched& one : chain.watched) {
              watched.push_back(end[3 * one.mass + one.axis]);
            }
            return watched;
          }};
}

/// Widths by measurement: see expert.cpp.
template <std::size_t Links, std::size_t Width, bool IsHeld = false>
std::vector<Contender> chain_by_hand(const HungChain& chain) {
  std::vector<Contender> all = explicit_methods(axis_by_axis<Links, Width, IsHeld>(chain));
  all.push_back(series<Links, IsHeld>(chain));
  return all;
}

template <class Model>
std::vector<Contender> as_declared(const Problem& problem, const std::vector<double>& start, Model model = {}) {
  return explicit_methods(second_order(std::move(model), problem, start));
}

/// A closed form for the explicit methods, the chain's recurrences for the series.
template <class Model, std::size_t Links, bool IsHeld>
std::vector<Contender> linkage(const Problem& problem, const std::vector<double>& start) {
  std::vector<Contender> all = as_declared<Model>(problem, start);
  all.push_back(series<Links, IsHeld>(hung_chain(problem, start).value()));
  return all;
}

/// Masses times the constant of gravitation: of the Sun and the five outer planets.
constexpr expert::Planets<6> planets{{2.95912208286e-4 * 1.00000597682, 2.95912208286e-4 * 0.000954786104043,
                                      2.95912208286e-4 * 0.000285583733151, 2.95912208286e-4 * 0.0000437273164546,
                                      2.95912208286e-4 * 0.0000517759138449, 2.95912208286e-4 * (1 / 1.3e8)}};

}  // namespace

std::vector<Contender> by_hand(const Problem& problem, const std::vector<double>& start) {
  const auto chain = [&] { return hung_chain(problem, start).value(); };
  const std::string& model = problem.model;
  return model == "kepler"               ? as_declared<expert::Kepler>(problem, start)
         : model == "henon_heiles"       ? as_declared<expert::HenonHeiles>(problem, start)
         : model == "outer_solar_system" ? as_declared(problem, start, planets)
         : model == "artigo5"            ? as_declared<expert::PaperExample>(problem, start)
         : model == "spherical_pendulum" ? linkage<expert::Pendulum, 1, false>(problem, start)
         : model == "four_bar"           ? linkage<expert::FourBar, 3, true>(problem, start)
         : model == "chain_3"            ? chain_by_hand<3, 4>(chain())
         : model == "chain_10"           ? chain_by_hand<10, 16>(chain())
         : model == "chain_50"           ? chain_by_hand<50, 52>(chain())
         : model == "chain_200"          ? chain_by_hand<200, 200>(chain())
         : model == "closed_ring"        ? chain_by_hand<12, 16, true>(chain())
                                         : std::vector<Contender>{};
}

}  // namespace bench::precision
