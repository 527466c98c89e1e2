#pragma once
// Modules, and what a part gives to the parameters and ports of its module.
//
// A module's names are its own: its statements see no name of the model around them, so that a part means the same
// wherever it is. What a part gives is an expression of the system around it.

#include <map>
#include <string_view>
#include <vector>

#include "model/context.hpp"
#include "model/imports.hpp"

namespace mbcc::model {

/// If the model consists of modules and settings alone, the one module of its file that no other one of the file uses
/// becomes the model.
void let_module_stand_alone(Statements& statements);

/// Enters the modules among `statements` into the symbols. Reports what no module can contain.
void collect_modules(const std::vector<const ast::Statement*>& statements, Context& context);

std::vector<const ast::Statement*> statements_of(const ast::Module& module);

/// A `port`, or a `point` that would be one directly in a module.
bool is_port(const ast::Statement& statement);

/// Null, with a finding, if there is none, or if it is one that `around` is inside of.
const ast::Module* find_module(const ast::Part& part, const Scope& around, Context& context);

/// What the part gives, by name; reports what its module does not know.
std::map<std::string_view, const ast::Field*> arguments_of(const ast::Part& part, const Scope& scope, Context& context);
std::map<std::string_view, const ast::Field*> ports_of(const ast::Part& part, const Scope& scope, Context& context);

/// Gives the definition of a parameter or port of `scope` the expression that the part has for it, if there is one.
/// Reports one that has no expression at all.
void bind_formal(Definition& formal, const Scope& scope, Context& context);
void bind_port(Definition& port, const Scope& scope, Context& context);

}  // namespace mbcc::model
