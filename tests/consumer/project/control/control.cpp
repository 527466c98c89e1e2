// A control loop around a model library: a sampled controller pushes the pendulum to a place and holds it there.

#include <cmath>
#include <cstdio>
#include <string_view>

#include "mbrt/rk4.hpp"
#include "pendulum.hpp"

namespace {

double& parameter(pendulum::Model& model, std::string_view name) {
  std::size_t index = 0;
  while (model.description().parameters[index].name != name) {
    ++index;
  }
  return model.parameters()[index];
}

/// The order of use that mbrt::Model asks for.
void start(pendulum::Model& model, const pendulum::Model::State& state) {
  model.prepare();
  model.set_time(0);
  for (int island = 0; island < static_cast<int>(model.description().islands.size()); ++island) {
    model.island_rows(island, state);
    mbrt::take_scales(model.island(island));
  }
}

}  // namespace

int main() {
  constexpr double target = 0.3;
  constexpr double period = 0.01;
  constexpr int periods = 1000;

  pendulum::Model model;
  pendulum::Model::State state = model.initial_state();  // x, y, vx, vy
  start(model, state);
  double& push = parameter(model, "push");
  const double holding = 9.81 * target / std::sqrt(1 - target * target);
  mbrt::Unobserved nobody;
  for (int i = 0; i < periods; ++i) {
    push = holding - 20 * (state[0] - target) - 6 * state[2];
    model.prepare();
    mbrt::rk4(model, state, mbrt::time_grid(i * period, (i + 1) * period, 0.001), nobody);
  }

  std::printf("x = %.12g, vx = %.3g, rod = %.12g\n", state[0], state[2], std::hypot(state[0], state[1]));
  // The loop's slowest mode decays by exp(-2.7 t), to 1e-12 in these 10 seconds; the rod drifts by rk4's error.
  const bool holds = std::abs(state[0] - target) < 1e-9 && std::abs(state[2]) < 1e-9 &&
                     std::abs(std::hypot(state[0], state[1]) - 1) < 1e-9;
  return holds ? 0 : 1;
}
