#pragma once
// A right-hand side q'' = a(t, q, v) by explicit methods that are not the runtime's.

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "expert/embedded_pair.hpp"
#include "expert/pairs.hpp"
#include "expert/second_order_rk4.hpp"
#include "precision/contender.hpp"
#include "precision/problems.hpp"

namespace bench::precision {

/// `Model` has set_time(t) and acceleration(motion, a).
template <class Model>
struct SecondOrder {
  Model model;
  expert::Motion<Model::size> start;
  std::vector<std::size_t> places;  ///< of what is watched: in q, then in v
  double to;

  std::vector<double> watched(const expert::Motion<Model::size>& y) const {
    std::vector<double> values;
    for (const std::size_t place : places) {
      values.push_back(place < Model::size ? y.q[place] : y.v[place - Model::size]);
    }
    return values;
  }
};

/// With the components where the model declares them.
template <class Model>
SecondOrder<Model> second_order(Model model, const Problem& problem, const std::vector<double>& start) {
  SecondOrder<Model> scene{std::move(model), {}, {}, problem.to};
  for (std::size_t j = 0; j < Model::size; ++j) {
    scene.start.q[j] = start[j];
    scene.start.v[j] = start[Model::size + j];
  }
  for (const Known& known : problem.end) {
    scene.places.push_back(known.component);
  }
  return scene;
}

template <class Pair, class Model>
Contender with_pair(std::string name, const SecondOrder<Model>& scene) {
  return {std::move(name), tolerances(), [scene](double tolerance) {
            expert::EmbeddedPair<Pair, Model::size, Model> pair(scene.model, scene.start, tolerance);
            return scene.watched(pair.integrate(scene.to));
          }};
}

template <class Model>
Contender with_rk4(std::string name, const SecondOrder<Model>& scene) {
  return {std::move(name), numbers_of_steps(), [scene](double steps) {
            const long count = std::lround(steps);
            return scene.watched(expert::rk4(scene.model, scene.start, scene.to / static_cast<double>(count), count));
          }};
}

}  // namespace bench::precision
