// Compiles only while the headers that emitted code includes stay light: of the libraries that the runtime is built
// from, and of streams, nothing may show through.

#include "mbrt/radau.hpp"
#include "mbrt/simulation.hpp"

#if defined(EIGEN_WORLD_VERSION) || defined(FMT_VERSION) || defined(CLI11_VERSION) || \
    defined(NLOHMANN_JSON_VERSION_MAJOR) || defined(_GLIBCXX_IOSTREAM) || defined(_GLIBCXX_OSTREAM)
#error "mbrt/simulation.hpp or mbrt/radau.hpp includes more than emitted code should pay for"
#endif
