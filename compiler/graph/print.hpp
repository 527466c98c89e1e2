#pragma once
// Expressions as text in the language of models, for dumps.

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "graph/graph.hpp"

namespace mbcc::graph {

/// The model's name of a leaf that is no constant.
using LeafName = std::function<std::string(const Node&)>;

/// One line per labelled expression, `label = text`; what several of them share is defined once, before, as `#n`.
std::string print(std::span<const std::pair<std::string, Expr>> labelled, const LeafName& leaf_name);

}  // namespace mbcc::graph
