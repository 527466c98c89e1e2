#pragma once
// What a result shows, beyond its numbers.

#include <string>
#include <vector>

#include "driver/compile.hpp"
#include "page/scene.hpp"

namespace mbcc {

struct Subject {
  std::string title;
  std::string source;  ///< the file that the result is from, as the user wrote it
  page::Skeleton skeleton;
};

/// Of a run of a model with `flags`, which the simulation has accepted: rods hang where `--set` puts them.
Subject subject_of_run(const Compilation& compilation, const std::string& model, const std::vector<std::string>& flags);

/// Of a recorded file, whose model is not known.
Subject subject_of_file(const std::string& path);

}  // namespace mbcc
