#pragma once
// What mbcc makes of a problem's model, by the runtime's methods.

#include <memory>
#include <vector>

#include "mbrt/dop853.hpp"
#include "mbrt/taylor.hpp"
#include "series/contender.hpp"

namespace bench::series {

/// A model ready to run from its own start, and what a run asks of it.
template <class M>
struct Ready {
  M model;
  typename M::State start;
  mbrt::Task task;

  explicit Ready(double to) {
    model.prepare();
    model.set_time(0);
    start = model.initial_state();
    if constexpr (mbrt::HasConstraints<M>) {
      for (int k = 0; k < static_cast<int>(M::description().islands.size()); ++k) {
        model.island_rows(k, start);
        mbrt::take_scales(model.island(k));
      }
    }
    typename M::State rate;
    model.rates(start, rate);
    task = {0, to, 0, 0, mbrt::scales_of(start, rate, M::coordinates), false};
  }
};

template <class M, class Method>
Contender with_method(const std::shared_ptr<Ready<M>>& ready) {
  return {std::string("mbcc, ") + Method::name, [ready](double tolerance) {
            typename M::State y = ready->start;
            mbrt::Task task = ready->task;
            task.tolerance = tolerance;
            mbrt::Unobserved nobody;
            ready->model.set_time(0);
            Method::run(ready->model, y, task, nobody);
            std::vector<double> end(y.begin(), y.end());
            for (std::size_t j = 0; j < M::description().columns.size(); ++j) {
              end[j] = y[static_cast<std::size_t>(M::description().columns[j])];
            }
            return end;
          }};
}

template <class M>
std::vector<Contender> contenders() {
  const auto ready = std::make_shared<Ready<M>>(M::description().defaults.to);
  return {with_method<M, mbrt::Taylor>(ready), with_method<M, mbrt::Dop853>(ready)};
}

}  // namespace bench::series
