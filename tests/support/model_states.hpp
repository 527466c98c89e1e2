#pragma once
// Models at chosen states, in the order of use that mbrt::Model asks for; the same for emitted classes and for the
// interpreter.

#include <mbrt/model.hpp>

namespace mbcc::test {

/// Brings `model` to its own start at `time`, row scales included, and returns the state there.
template <mbrt::Model M>
typename M::State start(M& model, double time = 0) {
  model.prepare();
  model.set_time(time);
  const typename M::State state = model.initial_state();
  if constexpr (mbrt::HasConstraints<M>) {
    for (int k = 0; k < static_cast<int>(model.description().islands.size()); ++k) {
      model.island_rows(k, state);
      mbrt::take_scales(model.island(k));
    }
  }
  return state;
}

template <mbrt::Model M>
typename M::State rates_at(M& model, double time, const typename M::State& state) {
  typename M::State rate = state;
  model.set_time(time);
  model.rates(state, rate);
  return rate;
}

}  // namespace mbcc::test
