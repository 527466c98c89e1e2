#pragma once
// All files of a model as one list of statements.

#include <deque>
#include <vector>

#include "model/reporter.hpp"
#include "model/resolve.hpp"

namespace mbcc::model {

/// The statements of the model and of what it imports, each file once, where it is first imported.
struct Statements {
  std::deque<ast::ModelFile> imported;  ///< owns what `all` points to, beside the model itself
  std::vector<const ast::Statement*> all;
  const ast::Module* alone = nullptr;  ///< the module that the model consists of; its statements are among `all`
};

Statements gather(const ast::ModelFile& model, const Sources& sources, const Importer& import, Reporter& report);

}  // namespace mbcc::model
