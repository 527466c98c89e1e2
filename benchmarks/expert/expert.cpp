#include "expert/expert.hpp"

#include <stdexcept>

#include "expert/chain.hpp"
#include "expert/paper_example.hpp"

namespace bench::expert {

namespace {

/// Where a component of a scene's coordinates, mass by mass, is kept: axis by axis, `width` apart.
struct AxisByAxis {
  std::size_t width;

  std::size_t operator()(std::size_t j) const { return (j % 3) * width + j / 3; }
};

struct AsDeclared {
  std::size_t operator()(std::size_t j) const { return j; }
};

template <class Model, class Place>
Contender integrate_with(Place place) {
  return {"expert", [place](std::span<double> state, double step, long steps) {
            Motion<Model::size> y;
            const std::size_t half = state.size() / 2;
            for (std::size_t j = 0; j < half; ++j) {
              y.q[place(j)] = state[j];
              y.v[place(j)] = state[half + j];
            }
            y = rk4(Model{}, y, step, steps);
            for (std::size_t j = 0; j < half; ++j) {
              state[j] = y.q[place(j)];
              state[half + j] = y.v[place(j)];
            }
            return 4 * steps;
          }};
}

template <std::size_t Links, std::size_t Width>
Contender chain() {
  return integrate_with<Chain<Links, Width>>(AxisByAxis{Width});
}

}  // namespace

Contender contender(std::string_view model) {
  // Widths by measurement: multiples of a vector of four, or of two of them where the loops are short.
  if (model == "artigo5") {
    return integrate_with<PaperExample>(AsDeclared{});
  }
  if (model == "chain_3") {
    return chain<3, 4>();
  }
  if (model == "chain_10") {
    return chain<10, 16>();
  }
  if (model == "chain_100") {
    return chain<100, 100>();
  }
  if (model == "chain_200") {
    return chain<200, 200>();
  }
  throw std::invalid_argument("no expert code for " + std::string(model));
}

}  // namespace bench::expert
