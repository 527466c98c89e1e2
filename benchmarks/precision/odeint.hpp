#pragma once
// A right-hand side q'' = a(t, q, v) by Boost.Odeint.

#include <array>
#include <boost/numeric/odeint.hpp>
#include <cstddef>
#include <string>
#include <utility>

#include "precision/second_order.hpp"

namespace bench::precision {

/// As Boost's documentation has it: a controlled stepper of a fixed-size state, from a first step of a thousandth.
template <class Model>
Contender with_odeint(std::string name, const SecondOrder<Model>& scene) {
  namespace odeint = boost::numeric::odeint;
  constexpr std::size_t size = Model::size;
  using State = std::array<double, 2 * size>;
  return {std::move(name), tolerances(), [scene](double tolerance) {
            State y;
            for (std::size_t j = 0; j < size; ++j) {
              y[j] = scene.start.q[j];
              y[size + j] = scene.start.v[j];
            }
            Model model = scene.model;
            const auto rates = [&model](const State& state, State& rate, double t) {
              expert::Motion<size> motion;
              expert::Vector<size> acceleration;
              for (std::size_t j = 0; j < size; ++j) {
                motion.q[j] = state[j];
                motion.v[j] = rate[j] = state[size + j];
              }
              model.set_time(t);
              model.acceleration(motion, acceleration);
              for (std::size_t j = 0; j < size; ++j) {
                rate[size + j] = acceleration[j];
              }
            };
            odeint::integrate_adaptive(
                odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance), rates, y, 0.0,
                scene.to, 1e-3 * scene.to);
            expert::Motion<size> end;
            for (std::size_t j = 0; j < size; ++j) {
              end.q[j] = y[j];
              end.v[j] = y[size + j];
            }
            return scene.watched(end);
          }};
}

}  // namespace bench::precision
