// The emitted models by name. precision_models.def, which the build writes, has one line EMITTED(name) for each; every
// class is compiled apart, as its user would.

#include "precision/program.hpp"

namespace bench::precision {

#define EMITTED(name) Program name##_program();
#include "precision_models.def"
#undef EMITTED

std::optional<Program> program_of(std::string_view model) {
#define EMITTED(name)        \
  if (model == #name) {      \
    return name##_program(); \
  }
#include "precision_models.def"
#undef EMITTED
  return std::nullopt;
}

}  // namespace bench::precision
