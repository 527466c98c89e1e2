#include "precision/pinv.hpp"

#include <memory>

#include "generic/scenes.hpp"
#include "generic/udwadia_kalaba.hpp"
#include "precision/hung_chain.hpp"
#include "precision/second_order.hpp"

namespace bench::precision {

namespace {

template <class Scene>
class AsSecondOrder {
 public:
  static constexpr std::size_t size = Scene::coordinates;

  void set_time(double t) { system_->set_time(t); }
  void acceleration(const expert::Motion<size>& y, expert::Vector<size>& a) {
    typename generic::UdwadiaKalaba<Scene>::State state, rate;
    for (std::size_t j = 0; j < size; ++j) {
      state[j] = y.q[j];
      state[size + j] = y.v[j];
    }
    system_->rates(state, rate);
    for (std::size_t j = 0; j < size; ++j) {
      a[j] = rate[size + j];
    }
  }

 private:
  std::shared_ptr<generic::UdwadiaKalaba<Scene>> system_ = std::make_shared<generic::UdwadiaKalaba<Scene>>();
};

template <class Scene>
std::vector<Contender> methods(const SecondOrder<AsSecondOrder<Scene>>& scene) {
  return {with_pair<expert::Dop853>("generic pinv, dop853", scene), with_rk4("generic pinv, rk4", scene)};
}

/// Mass by mass, x, y, z of each.
template <std::size_t Links, bool IsHeld = false>
std::vector<Contender> chain_methods(const HungChain& chain) {
  SecondOrder<AsSecondOrder<generic::Chain<Links, IsHeld>>> scene{{}, {}, {}, chain.to};
  for (std::size_t j = 0; j < 3 * chain.masses.size(); ++j) {
    scene.start.q[j] = chain.masses[j / 3].position[j % 3];
    scene.start.v[j] = chain.masses[j / 3].velocity[j % 3];
  }
  for (const HungChain::Watched& watched : chain.watched) {
    scene.places.push_back(3 * watched.mass + watched.axis);
  }
  return methods(scene);
}

template <class Scene>
std::vector<Contender> as_declared(const Problem& problem, const std::vector<double>& start) {
  return methods(second_order(AsSecondOrder<Scene>{}, problem, start));
}

}  // namespace

std::vector<Contender> by_pinv(const Problem& problem, const std::vector<double>& start) {
  const auto chain = [&] { return hung_chain(problem, start).value(); };
  const std::string& model = problem.model;
  return model == "artigo5"              ? as_declared<generic::PaperExample>(problem, start)
         : model == "four_bar"           ? as_declared<generic::FourBar>(problem, start)
         : model == "spherical_pendulum" ? chain_methods<1>(chain())
         : model == "chain_3"            ? chain_methods<3>(chain())
         : model == "chain_10"           ? chain_methods<10>(chain())
         : model == "closed_ring"        ? chain_methods<12, true>(chain())
                                         : std::vector<Contender>{};
}

}  // namespace bench::precision
