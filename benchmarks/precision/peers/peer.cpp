#include "precision/peers/peer.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "precision/measure.hpp"

namespace bench::precision {

namespace {

std::array<double, 3> read_vector(std::istream& in) {
  std::array<double, 3> vector{};
  in >> vector[0] >> vector[1] >> vector[2];
  return vector;
}

HungChain read_scene(const std::string& path) {
  std::ifstream file(path);
  HungChain chain;
  for (std::string word; file >> word;) {
    if (word == "to") {
      file >> chain.to;
    } else if (word == "mass") {
      const std::array<double, 3> position = read_vector(file);
      chain.masses.push_back({position, read_vector(file)});
    } else if (word == "far") {
      chain.far_end = read_vector(file);
    } else if (word == "watch") {
      HungChain::Watched watched{};
      file >> watched.mass >> watched.axis >> watched.value;
      chain.watched.push_back(watched);
    } else {
      throw std::runtime_error(path + ": `" + word + "` means nothing here");
    }
  }
  if (!file.eof() || chain.masses.empty()) {
    throw std::runtime_error("cannot read " + path);
  }
  return chain;
}

void measure_scene(const std::string& path, const std::function<std::vector<Contender>(const HungChain&)>& contenders) {
  const HungChain chain = read_scene(path);
  Problem problem{std::filesystem::path(path).stem(), "", "", chain.to, {}};
  for (const HungChain::Watched& one : chain.watched) {
    problem.end.push_back({0, one.value});
  }
  for (const Point& point : measure(contenders(chain), problem, Effort{5, 0.3})) {
    fmt::print("{}\t{}\t{:.3g}\t{:.4g}\t{:.3g}\n", problem.name, point.contender, point.setting, point.seconds,
               point.error);
    std::fflush(stdout);
  }
}

}  // namespace

int run_peer(int argc, char** argv, const std::function<std::vector<Contender>(const HungChain&)>& contenders) {
  try {
    for (int i = 1; i < argc; ++i) {
      measure_scene(argv[i], contenders);
    }
    return 0;
  } catch (const std::exception& failure) {
    fmt::print(stderr, "{}: {}\n", argv[0], failure.what());
    return 1;
  }
}

}  // namespace bench::precision
