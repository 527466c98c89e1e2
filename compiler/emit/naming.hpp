#pragma once
// The identifiers that all kernels of an emitted class share.

#include <string>
#include <unordered_map>
#include <vector>

#include "emit/names.hpp"
#include "model/system.hpp"
#include "program/program.hpp"

namespace mbcc::cpp {

struct Naming {
  Scope scope;  ///< with all of them declared; each kernel has one nested in it
  std::vector<std::string> coordinates, speeds, accelerations, parameters;
  std::vector<std::string> coordinate_changes, speed_changes;  ///< where the program has a tangent
  std::unordered_map<program::NodeId, std::string> members;    ///< values kept between kernels
  bool keeps_time = false;                                     ///< whether a kernel reads t itself

  /// The local name of a leaf: `p_3_x`.
  std::string name_of_leaf(graph::Kind kind, std::uint32_t index) const;
  /// Where its value comes from, with `index` as text: `y[3 * i + 6]`.
  static std::string source_of_leaf(graph::Kind kind, const std::string& index);
  /// The first index of leaves of a kind in what source_of_leaf names.
  std::size_t offset_of(graph::Kind kind) const;
};

Naming make_naming(const model::System& system, const program::Program& program);

}  // namespace mbcc::cpp
