#pragma once
// What mbcc makes of a model.

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "mbrt/model.hpp"
#include "runtime_rk4.hpp"

namespace bench::emitted {

struct Program {
  std::vector<double> start;  ///< the model's own
  Contender contender;        ///< both in order of declaration
};

/// Prepares a model as every program does that uses one: row scales are those at the start.
template <mbrt::Model M>
Program program() {
  auto model = std::make_shared<M>();
  model->prepare();
  model->set_time(0);
  const typename M::State start = model->initial_state();
  if constexpr (mbrt::HasConstraints<M>) {
    for (int k = 0; k < static_cast<int>(M::description().islands.size()); ++k) {
      model->island_rows(k, start);
      mbrt::take_scales(model->island(k));
    }
  }
  const Places places(M::description().columns.begin(), M::description().columns.end());
  Program program{{start.begin(), start.end()}, with_runtime_rk4("emitted", model, places)};
  for (std::size_t j = 0; j < places.size(); ++j) {
    program.start[j] = start[places[j]];
  }
  return program;
}

/// The program of a model of this name; nothing where this build has no mbcc.
std::optional<Program> find(std::string_view model);

}  // namespace bench::emitted
