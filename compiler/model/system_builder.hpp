#pragma once
// Fills the System from the statements of a model, one function per kind of statement.

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/declare.hpp"
#include "model/system.hpp"

namespace mbcc::model {

class SystemBuilder {
 public:
  SystemBuilder(Evaluator& evaluator, Context& context, System& system)
      : evaluator_(evaluator), context_(context), system_(system) {}

  /// Finds out which rates statements tell, and numbers coordinates and speeds: before anything is evaluated.
  void find_motions(const std::vector<Instance>& instances);
  void number_variables();

  void add_parameters();
  void add_particles();  ///< coordinates and speeds, then the forces that are given inside of particles
  void add_variables();
  void order_starts();  ///< when all coordinates and speeds are there
  void add(const Instance& instance);

 private:
  // particles.cpp
  using Fields = std::map<std::string_view, const ast::Field*>;
  void add_motion(const Particle& particle, const Fields& fields);
  Value start_of(const Particle& particle, const ast::Field* field, std::string_view what, Quantities unwanted);
  void report_missing(const Particle& particle, std::string_view field);
  ExpressionId mass_of(const Particle& particle, const ast::Field* field);

  // variables.cpp
  void add_variable(const Variable& variable);
  ExpressionId start_of(const Variable& variable, const Fields& fields, std::string_view field);
  ExpressionId rate_of(const Variable& variable);
  void report_cyclic_rates();
  void add(const ast::Energy& energy, const Instance& instance);

  // forces.cpp
  void add_force(const Particle& particle, const ast::Expression& expression, const Frame* frame);
  void add_force(Definition& point, const ast::ForceOn& force, const Frame* frame);
  void add_force(std::string_view kind, const Particle& particle, std::size_t axis, const Scalar& value, Span span);
  void add_force(const Variable& variable, const ast::Expression& expression, const Frame* frame);
  void add(const ast::ForceOn& force, const Instance& instance);
  void add(const ast::Gravity& gravity, const Instance& instance);

  // constraints.cpp
  void add(const ast::Constraint& constraint, const Instance& instance);
  Value equation(const ast::Constraint& constraint, Span span, const Frame* frame);
  bool can_hold(const std::string& name, const Operand& row);

  // outputs.cpp
  void add(const ast::Output& output, const Instance& instance);
  void add_column(const std::string& name, const Scalar& value, const ast::Output& output);

  // integration.cpp
  void add(const ast::Integrate& integrate, const Instance& instance);
  void set(const ast::Field& field, const Frame* frame, Integration& integration);
  void set_method(const ast::Expression& value, Integration& integration);

  void add(const ast::System& title, const Instance& instance);
  template <class Declaration>
  void add(const Declaration& /*known by its name*/, const Instance& /*instance*/) {}

  /// An expression that is a speed.
  ExpressionId speed_node(std::uint32_t index, Span span) {
    return *context_.arena.leaf(ExpressionKind::Speed, index, span).node;
  }

  // requirements.cpp
  Value expect_vector(const Operand& operand, std::string_view what) {
    return evaluator_.algebra().expect_vector(operand, what);
  }
  bool expect_independent(const Operand& operand, Quantities unwanted, std::string_view what) {
    return evaluator_.algebra().expect_independent(operand, unwanted, what);
  }
  /// The fields of a block by name, without those that are unknown or given twice.
  Fields fields_of(std::string_view block, const std::vector<ast::Field>& fields,
                   const std::vector<std::string_view>& known);

  Evaluator& evaluator_;
  Context& context_;
  System& system_;
  std::set<std::string> motion_columns_ = {"t"};
  std::map<std::string, Span> output_columns_;
};

/// The value of `id` where every parameter has its default; nothing if one that it needs has none, which has been
/// reported.
std::optional<double> value_at_defaults(const Arena& arena, const std::vector<Parameter>& parameters, ExpressionId id);

/// The span of one component if `expression` is written as a vector, else of all of it.
Span component_span(const ast::Expression& expression, std::size_t axis);

}  // namespace mbcc::model
