// Coordinates, speeds and first-order states, what tells their rates, and energies.

#include <fmt/format.h>

#include <algorithm>

#include "model/system_builder.hpp"

namespace mbcc::model {
namespace {

/// Coordinates whose rates occur in an expression, as indices, increasing.
std::set<std::uint32_t> rates_in(const Arena& arena, ExpressionId root) {
  std::set<std::uint32_t> coordinates;
  std::set<std::pair<ExpressionId, bool>> seen;
  std::vector<std::pair<ExpressionId, bool>> open = {{root, false}};
  while (!open.empty()) {
    const auto [id, in_rate] = open.back();
    open.pop_back();
    if (!seen.insert({id, in_rate}).second) {
      continue;
    }
    const Expression& expression = arena.expressions()[index(id)];
    if (in_rate && expression.kind == ExpressionKind::Coordinate) {
      coordinates.insert(expression.index);
    }
    for (std::size_t i = 0; i < operand_count(expression); ++i) {
      open.emplace_back(expression.operands[i], in_rate || expression.kind == ExpressionKind::Rate);
    }
  }
  return coordinates;
}

}  // namespace

void SystemBuilder::find_motions(const std::vector<Instance>& instances) {
  for (const Instance& instance : instances) {
    const auto* syntax = std::get_if<ast::Motion>(&instance.statement->node);
    Variable* variable = syntax == nullptr ? nullptr : evaluator_.moving(*syntax, instance.frame);
    if (variable == nullptr) {
      continue;
    }
    if (variable->motion != nullptr) {
      context_.report.report(Finding::GivenTwice, syntax->target.span, variable->name + "'")
          .note(variable->motion->target.span, "first given here");
      continue;
    }
    variable->motion = syntax;
    variable->motion_frame = instance.frame;
  }
}

void SystemBuilder::number_variables() {
  auto coordinates =
      static_cast<std::uint32_t>(context_.symbols.particles.size()) * static_cast<std::uint32_t>(context_.dimension);
  std::uint32_t speeds = coordinates;
  for (Variable& variable : context_.symbols.variables) {
    if (!variable.is_speed()) {
      variable.coordinate = coordinates++;
    }
    if (variable.has_speed()) {
      variable.speed = speeds++;
    }
  }
}

void SystemBuilder::add_variables() {
  for (const Variable& variable : context_.symbols.variables) {
    add_variable(variable);
  }
  for (const Variable& variable : context_.symbols.variables) {
    if (variable.motion != nullptr) {
      system_.coordinates[variable.coordinate].rate = rate_of(variable);
    }
  }
  report_cyclic_rates();
}

void SystemBuilder::add_variable(const Variable& variable) {
  const bool may_have_rate = !variable.is_speed() && variable.has_speed();
  const std::string_view word = describe(kind_of(variable.syntax->kind)).substr(2);
  const Fields fields =
      fields_of(word, variable.syntax->fields,
                variable.syntax->kind == ast::VariableKind::Coordinate ? std::vector<std::string_view>{"value", "rate"}
                                                                       : std::vector<std::string_view>{"value"});
  const Span span = variable.syntax->name.span;
  const ExpressionId zero = context_.arena.node({}, span);
  const ExpressionId value = start_of(variable, fields, "value");
  if (!variable.is_speed()) {
    motion_columns_.insert(variable.name);
    system_.declared_coordinates.push_back(CoordinateId{variable.coordinate});
    system_.coordinates.push_back({variable.name, zero, value, span});
  }
  if (variable.is_speed()) {
    system_.speeds.push_back({variable.name, variable.name + "'", zero, value, span});
  } else if (may_have_rate) {
    system_.coordinates.back().rate = speed_node(variable.speed, span);
    const ExpressionId rate = fields.contains("rate") ? start_of(variable, fields, "rate") : zero;
    system_.speeds.push_back({variable.name + "'", variable.name + "''", zero, rate, span});
  } else if (const auto rate = fields.find("rate"); rate != fields.end()) {
    context_.report.report(Finding::RateIsGiven, rate->second->name_span, variable.name)
        .note(variable.motion->target.span, "given here");
  }
  if (variable.has_speed()) {
    motion_columns_.insert({system_.speeds.back().name, system_.speeds.back().acceleration});
    system_.declared_speeds.push_back(SpeedId{variable.speed});
  }
  if (variable.is_state() && variable.motion == nullptr) {
    context_.report.report(Finding::StateWithoutEquation, span, variable.name, variable.name);
  }
}

ExpressionId SystemBuilder::start_of(const Variable& variable, const Fields& fields, std::string_view field) {
  const auto found = fields.find(field);
  if (found == fields.end()) {
    if (!context_.report.is_damaged(variable.statement)) {
      context_.report.report(Finding::MissingField, variable.syntax->name.span, fmt::format("`{}`", variable.name),
                             field, field);
    }
    return {};
  }
  const ast::Expression& expression = found->second->value;
  const Operand start{evaluator_.evaluate(expression, variable.frame), expression.span};
  const std::string what = fmt::format("the initial {} of `{}`", field, variable.name);
  const bool is_speed = variable.is_speed() || field == "rate";
  const Quantities unwanted = Quantities::Time | Quantities::Acceleration;
  const bool fits = evaluator_.algebra().expect_number(start, what) &&
                    expect_independent(start, is_speed ? unwanted : unwanted | Quantities::Speed, what);
  return fits ? context_.arena.node(start.value[0], start.span) : ExpressionId{};
}

ExpressionId SystemBuilder::rate_of(const Variable& variable) {
  const ast::Expression& expression = variable.motion->value;
  const Operand rate{evaluator_.evaluate(expression, variable.motion_frame), expression.span};
  const std::string what = fmt::format("the rate of `{}`", variable.name);
  const bool fits =
      evaluator_.algebra().expect_number(rate, what) && expect_independent(rate, Quantities::Acceleration, what);
  return fits ? context_.arena.node(rate.value[0], rate.span) : context_.arena.node({}, rate.span);
}

/// Follows rates that need rates, and reports one that comes back to itself.
void SystemBuilder::report_cyclic_rates() {
  std::map<std::uint32_t, const Variable*> told;
  for (const Variable& variable : context_.symbols.variables) {
    if (variable.motion != nullptr) {
      told.emplace(variable.coordinate, &variable);
    }
  }
  std::set<std::uint32_t> settled;
  std::vector<std::uint32_t> path;
  const auto follow = [&](const auto& self, std::uint32_t coordinate) -> void {
    const auto first = std::find(path.begin(), path.end(), coordinate);
    if (first != path.end()) {
      std::string text;
      for (auto step = first; step != path.end(); ++step) {
        text += fmt::format("`{}'` needs ", told.at(*step)->name);
      }
      const Variable& variable = *told.at(coordinate);
      context_.report.report(Finding::DefinedByItself, variable.motion->target.span, variable.name + "'",
                             fmt::format("{}`{}'`", text, variable.name));
    } else if (told.contains(coordinate) && settled.insert(coordinate).second) {
      path.push_back(coordinate);
      for (const std::uint32_t needed : rates_in(context_.arena, system_.coordinates[coordinate].rate)) {
        self(self, needed);
      }
      path.pop_back();
    }
  };
  for (const auto& [coordinate, variable] : told) {
    follow(follow, coordinate);
  }
}

void SystemBuilder::add(const ast::Energy& energy, const Instance& instance) {
  const Operand value{evaluator_.evaluate(energy.value, instance.frame), energy.value.span};
  const bool is_kinetic = energy.kind == ast::EnergyKind::Kinetic;
  const std::string_view what = is_kinetic ? "a kinetic energy" : "a potential energy";
  const Quantities unwanted = is_kinetic ? Quantities::Acceleration : Quantities::Speed | Quantities::Acceleration;
  if (evaluator_.algebra().expect_number(value, what) && expect_independent(value, unwanted, what)) {
    (is_kinetic ? system_.kinetic : system_.potential)
        .push_back({context_.arena.node(value.value[0], value.span), value.span});
  }
}

}  // namespace mbcc::model
