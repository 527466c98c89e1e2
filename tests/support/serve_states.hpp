#pragma once
// The main program of generated test code: answers, model by model, states with everything_at them. Numbers are raw
// doubles.

#include <cstdint>
#include <istream>
#include <memory>
#include <ostream>

#include "support/model_states.hpp"

namespace mbcc::test {

/// Reads how many states follow, then (time, state) for each; writes the answer to each, its size first.
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
    const std::vector<double> answer = everything_at(*model, time, state);
    const std::uint64_t size = answer.size();
    out.write(reinterpret_cast<const char*>(&size), sizeof size);
    out.write(reinterpret_cast<const char*>(answer.data()), static_cast<std::streamsize>(size * sizeof(double)));
  }
}

}  // namespace mbcc::test
