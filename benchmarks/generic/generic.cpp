#include "generic/generic.hpp"

#include <memory>

#include "generic/scenes.hpp"
#include "generic/udwadia_kalaba.hpp"
#include "runtime_rk4.hpp"

namespace bench::generic {

namespace {

template <class Scene>
Contender integrate() {
  return with_runtime_rk4("generic", std::make_shared<UdwadiaKalaba<Scene>>());
}

}  // namespace

std::optional<Contender> contender(std::string_view model) {
  if (model == "artigo5") {
    return integrate<PaperExample>();
  }
  if (model == "chain_3") {
    return integrate<Chain<3>>();
  }
  if (model == "chain_10") {
    return integrate<Chain<10>>();
  }
  if (model == "chain_100") {
    return integrate<Chain<100>>();
  }
  return std::nullopt;
}

}  // namespace bench::generic
