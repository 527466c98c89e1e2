#include "model/compact.hpp"

#include "model/arena.hpp"

namespace mbcc::model {
namespace {

template <class Visit>
void for_each_root(System& system, const Visit& visit) {
  for (Coordinate& coordinate : system.coordinates) {
    visit(coordinate.rate);
    visit(coordinate.initial);
  }
  for (Speed& speed : system.speeds) {
    visit(speed.inertia);
    visit(speed.initial);
  }
  for (Force& force : system.forces) {
    visit(force.along);
    visit(force.value);
  }
  for (std::vector<Energy>* energies : {&system.kinetic, &system.potential}) {
    for (Energy& energy : *energies) {
      visit(energy.value);
    }
  }
  for (Constraint& constraint : system.constraints) {
    visit(constraint.value);
  }
  for (Output& output : system.outputs) {
    visit(output.value);
  }
}

}  // namespace

void compact(System& system) {
  std::vector<Expression>& all = system.expressions;
  std::vector<bool> is_used(all.size());
  for_each_root(system, [&](ExpressionId root) { is_used[index(root)] = true; });
  for (std::size_t i = all.size(); i-- > 0;) {
    for (std::size_t k = 0; is_used[i] && k < operand_count(all[i]); ++k) {
      is_used[index(all[i].operands[k])] = true;
    }
  }
  std::vector<ExpressionId> moved(all.size());
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_used[i]) {
      Expression expression = all[i];
      for (std::size_t k = 0; k < operand_count(expression); ++k) {
        expression.operands[k] = moved[index(expression.operands[k])];
      }
      moved[i] = ExpressionId{kept};
      all[kept++] = expression;
    }
  }
  all.resize(kept);
  for_each_root(system, [&](ExpressionId& root) { root = moved[index(root)]; });
}

}  // namespace mbcc::model
