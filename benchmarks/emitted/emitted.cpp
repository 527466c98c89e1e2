// The emitted models by name. emitted_models.def, which the build writes, has one line EMITTED(name) for each; every
// class is compiled apart, as its user would.

#include "emitted/emitted.hpp"

namespace bench::emitted {

#define EMITTED(name) Program name##_program();
#include "emitted_models.def"
#undef EMITTED

std::optional<Program> find([[maybe_unused]] std::string_view model) {
#define EMITTED(name)        \
  if (model == #name) {      \
    return name##_program(); \
  }
#include "emitted_models.def"
#undef EMITTED
  return std::nullopt;
}

}  // namespace bench::emitted
