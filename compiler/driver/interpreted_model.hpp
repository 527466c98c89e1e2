#pragma once
// A Program as a model that runs without a C++ compiler: it satisfies mbrt::Model, with sizes known at run time.

#include <deque>
#include <mbrt/model.hpp>
#include <string>
#include <vector>

#include "model/system.hpp"
#include "program/program.hpp"
#include "source/source.hpp"

namespace mbcc {

/// Keeps a value per node of the program's graph and executes kernels over them, in the same order and with the same
/// operations as emitted code.
class InterpretedModel {
 public:
  using State = std::vector<double>;

  /// `program` must outlive the model; all else is copied.
  InterpretedModel(const program::Program& program, const model::System& system, const Sources& sources);

  const mbrt::Description& description() const { return description_; }
  std::span<double> parameters() { return parameters_; }
  void prepare();
  State initial_state();
  void set_time(double time);
  void rates(const State& y, State& rate);
  bool tangent(const State& y, const State& direction, State& change);  ///< false without the code for it
  mbrt::Island island(int island);
  void island_rows(int island, const State& y);
  void constraint_errors(const State& y, const State& rate, std::span<double> position, std::span<double> velocity,
                         std::span<double> acceleration);
  void couple(const State& y, const State& rate, std::span<double> shift);
  void uncouple(const State& y, const State& rate, std::span<double> shift);
  void move(const State& y, const State& rate, std::span<double> shift);
  double energy(const State& y);
  void outputs(const State& y, const State& rate, std::span<double> values);
  void applied_forces(const State& y, std::span<double> values);

 private:
  struct IslandArrays {
    std::vector<double> scale, floor, scratch, matrix, residual, free, mobility, position, velocity, added;
    mbrt::IslandRecord record;
  };
  struct Leaf {
    program::NodeId node;
    std::size_t index;
  };

  void describe(const model::System& system, const Sources& sources);
  void load(const std::vector<Leaf>& leaves, std::span<const double> values);
  template <class Put>
  void execute(const program::Section& section, const Put& put);
  template <class Put>
  void execute(const program::Kernel& kernel, const Put& put);
  void shift(const program::Kernel& kernel, const State& y, const State& rate, std::span<double> shift);
  template <class Holds>
  bool guards_hold(const program::IslandSolve& island, const Holds& holds) const;
  void solve(const program::IslandSolve& island, const State& y, State& rate);

  const program::Program& program_;
  std::size_t coordinates_;
  std::vector<double> values_;  ///< by node
  std::vector<double> parameters_;
  std::vector<Leaf> component_leaves_, rate_leaves_, direction_leaves_, parameter_leaves_, time_leaves_;
  std::vector<IslandArrays> islands_;

  // What the description points to.
  std::deque<std::string> texts_;
  std::vector<const char*> coordinate_names_, speed_names_, acceleration_names_, output_names_;
  std::vector<mbrt::ParameterEntry> parameter_entries_;
  std::vector<mbrt::ConstraintEntry> constraint_entries_;
  std::vector<mbrt::ForceEntry> force_entries_;
  std::deque<std::vector<int>> indices_;
  std::vector<mbrt::IslandEntry> island_entries_;
  mbrt::Description description_;
};

static_assert(mbrt::Model<InterpretedModel>);
static_assert(program::plain_pivot_ratio(2) == mbrt::plain_pivot_ratio(2));
static_assert(program::plain_pivot_ratio(3) == mbrt::plain_pivot_ratio(3));

}  // namespace mbcc
