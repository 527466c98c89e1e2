#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "diagnostics/spelling.hpp"
#include "model/methods.hpp"
#include "model/system_builder.hpp"

namespace mbcc::model {
namespace {

struct NumberField {
  std::string_view name;
  std::optional<double> Integration::*value;
  bool must_be_positive;
};
constexpr std::array number_fields = {
    NumberField{"from", &Integration::from, false},          NumberField{"to", &Integration::to, false},
    NumberField{"step", &Integration::step, true},           NumberField{"every", &Integration::every, true},
    NumberField{"tolerance", &Integration::tolerance, true},
};

}  // namespace

void SystemBuilder::add(const ast::Integrate& integrate, const Instance& instance) {
  std::vector<std::string_view> known = {"method"};
  for (const NumberField& field : number_fields) {
    known.push_back(field.name);
  }
  const Fields fields = fields_of("integrate", integrate.fields, known);
  Integration set_here;
  for (const auto& [name, field] : fields) {
    if (name == "method") {
      set_method(field->value, set_here);
    } else {
      set(*field, instance.frame, set_here);
    }
  }
  const double from = set_here.from.value_or(0);
  if (set_here.to && *set_here.to < from) {
    context_.report.report(Finding::EndsBeforeStart, fields.at("to")->value.span, *set_here.to, from);
  }
  if (!instance.frame->scope->is_part()) {
    system_.integration = set_here;
  }
}

void SystemBuilder::set(const ast::Field& field, const Frame* frame, Integration& integration) {
  for (const NumberField& known : number_fields) {
    if (known.name != field.name) {
      continue;
    }
    const std::optional<double> number = evaluator_.structural(field.value, frame, fmt::format("`{}`", field.name));
    if (number && known.must_be_positive && *number <= 0) {
      context_.report.report(Finding::NotPositive, field.value.span, field.name, *number);
    }
    integration.*known.value = number;
  }
}

void SystemBuilder::set_method(const ast::Expression& value, Integration& integration) {
  const auto* word = std::get_if<ast::Reference>(&value.node);
  if (word == nullptr || word->steps.size() != 1 || !word->steps[0].indices.empty()) {
    context_.report.report(Finding::MethodExpected, value.span);
    return;
  }
  const std::string& method = word->steps[0].name;
  const std::vector<std::string_view> known = method_names();
  if (std::find(known.begin(), known.end(), method) == known.end()) {
    context_.report.report(Finding::UnknownMethod, value.span, method, suggestion(method, known));
  }
  integration.method = method;
}

}  // namespace mbcc::model
