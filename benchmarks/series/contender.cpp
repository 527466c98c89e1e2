// The emitted models by name. series_models.def, which the build writes, has one line EMITTED(name) for each; every
// class is compiled apart, as its user would.

#include "series/contender.hpp"

#include <memory>

#include "series/hand_chain.hpp"

namespace bench::series {

#define EMITTED(name) std::vector<Contender> name##_contenders();
#include "series_models.def"
#undef EMITTED

std::vector<Contender> emitted([[maybe_unused]] std::string_view model) {
#define EMITTED(name)           \
  if (model == #name) {         \
    return name##_contenders(); \
  }
#include "series_models.def"
#undef EMITTED
  return {};
}

namespace {

template <std::size_t Links>
Contender chain_by_hand(double to) {
  std::vector<double> start(6 * Links);
  for (std::size_t i = 0; i < Links; ++i) {
    const double n = static_cast<double>(i + 1);
    start[3 * i] = 0.8 * n;
    start[3 * i + 2] = -0.6 * n;
    start[3 * Links + 3 * i + 1] = 0.3 * n;
  }
  return {"by hand, Taylor", [chain = std::make_shared<HandChain<Links>>(), start, to](double tolerance) {
            return chain->integrate(start, to, tolerance);
          }};
}

}  // namespace

std::optional<Contender> by_hand(std::string_view model, double to) {
  return model == "chain_3"    ? std::optional(chain_by_hand<3>(to))
         : model == "chain_10" ? std::optional(chain_by_hand<10>(to))
                               : std::nullopt;
}

}  // namespace bench::series
