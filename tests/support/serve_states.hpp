#pragma once
// The main program of generated test code: answers, model by model, states with their rates. Numbers are raw doubles.

#include <cstdint>
#include <istream>
#include <memory>
#include <ostream>

#include "support/model_states.hpp"

namespace mbcc::test {

/// Reads how many states follow, then (time, state) for each; writes the rate of each.
template <mbrt::Model M>
void serve_states(std::istream& in, std::ostream& out) {
  const auto model = std::make_unique<M>();
  typename M::State state = start(*model);
  const auto bytes = static_cast<std::streamsize>(state.size() * sizeof(double));
  std::uint64_t count = 0;
  in.read(reinterpret_cast<char*>(&count), sizeof count);
  while (count-- > 0) {
    double time = 0;
    in.read(reinterpret_cast<char*>(&time), sizeof time);
    in.read(reinterpret_cast<char*>(state.data()), bytes);
    const typename M::State rate = rates_at(*model, time, state);
    out.write(reinterpret_cast<const char*>(rate.data()), bytes);
  }
}

}  // namespace mbcc::test
