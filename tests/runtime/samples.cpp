// `samples SCENE flags...`: the scenes as emitted programs would run them.

#include <string_view>

#include "mbrt/rk4.hpp"
#include "mbrt/simulation.hpp"
#include "scenes.hpp"

namespace {

template <class Scene>
int run(int argc, char** argv) {
  static_assert(mbrt::Model<mbrt::test::SampleModel<Scene>>);
  mbrt::test::SampleModel<Scene> model;
  return mbrt::simulate<mbrt::Rk4>(model, argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace mbrt::test;
  constexpr struct {
    std::string_view name;
    int (*run)(int, char**);
  } scenes[] = {{"pendulum", run<Pendulum>},
                {"paper", run<Paper>},
                {"throw", run<Throw>},
                {"edge", run<Edge>},
                {"cliff", run<Cliff>},
                {"contradiction", run<Contradiction>},
                {"redundant", run<Redundant>},
                {"vanishing", run<Vanishing>},
                {"opening", run<Opening>},
                {"loose", run<Loose>},
                {"pole", run<Pole>}};
  for (const auto& scene : scenes) {
    if (argc > 1 && scene.name == argv[1]) {
      return scene.run(argc - 1, argv + 1);
    }
  }
  return 64;
}
