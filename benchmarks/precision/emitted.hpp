#pragma once
// What mbcc makes of a problem's model, by the runtime's methods.

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mbrt/dop853.hpp"
#include "mbrt/model.hpp"
#include "mbrt/rk4.hpp"
#include "mbrt/taylor.hpp"
#include "precision/program.hpp"

namespace bench::precision {

/// A model ready to run, as every program makes it: row scales are those at the start.
template <class M>
struct Ready {
  M model;
  typename M::State start;
  mbrt::Scales scales;

  Ready() {
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
    scales = mbrt::scales_of(start, rate, M::coordinates);
  }

  static std::size_t place(std::size_t component) {
    const std::span<const int> columns = M::description().columns;
    return columns.empty() ? component : static_cast<std::size_t>(columns[component]);
  }

  template <class Method>
  std::vector<double> integrate(mbrt::Task task, const Problem& problem) {
    typename M::State y = start;
    task.to = problem.to;
    task.scales = scales;
    mbrt::Unobserved nobody;
    model.set_time(0);
    const mbrt::Course course = Method::run(model, y, task, nobody);
    std::vector<double> end;
    for (const Known& known : problem.end) {
      end.push_back(course.ending == mbrt::Ending::Complete ? y[place(known.component)] : std::nan(""));
    }
    return end;
  }
};

/// A method that chooses its steps, as runs have it if nothing is said: with projection.
template <class M, class Method>
Contender adaptive(const std::shared_ptr<Ready<M>>& ready, const Problem& problem) {
  return {std::string("mbcc, ") + Method::name, tolerances(), [ready, problem](double tolerance) {
            return ready->template integrate<Method>({0, 0, 0, tolerance, {}, mbrt::Projectable<M>}, problem);
          }};
}

template <class M>
std::vector<Contender> contenders(const std::shared_ptr<Ready<M>>& ready, const Problem& problem) {
  return {adaptive<M, mbrt::Taylor>(ready, problem),
          adaptive<M, mbrt::Dop853>(ready, problem),
          {"mbcc, rk4", numbers_of_steps(), [ready, problem](double steps) {
             return ready->template integrate<mbrt::Rk4>({0, 0, problem.to / steps, 0, {}, false}, problem);
           }}};
}

template <class M>
Program program() {
  const auto ready = std::make_shared<Ready<M>>();
  Program program;
  const mbrt::Description& description = M::description();
  for (std::size_t j = 0; j < ready->start.size(); ++j) {
    const std::size_t place = Ready<M>::place(j);
    program.names.push_back(place < M::coordinates ? description.coordinates[place]
                                                   : description.speeds[place - M::coordinates]);
    program.start.push_back(ready->start[place]);
  }
  program.contenders = [ready](const Problem& problem) { return contenders<M>(ready, problem); };
  return program;
}

}  // namespace bench::precision
