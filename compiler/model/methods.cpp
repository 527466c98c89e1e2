#include "model/methods.hpp"

#include <algorithm>

namespace mbcc::model {

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const Method& method : methods) {
    names.push_back(method.name);
  }
  names.push_back(automatic);
  return names;
}

std::vector<Method> methods_of(const Integration& integration) {
  const std::string_view fallback = integration.chooses_step() ? "dop853" : "rk4";
  const std::string_view wanted = integration.method ? std::string_view(*integration.method) : fallback;
  std::vector<Method> chosen;
  std::copy_if(methods.begin(), methods.end(), std::back_inserter(chosen), [wanted](const Method& method) {
    return wanted == automatic ? method.steps == Steps::Chosen : wanted == method.name;
  });
  return chosen;
}

bool needs(const Integration& integration, Code code) {
  const std::vector<Method> chosen = methods_of(integration);
  return std::any_of(chosen.begin(), chosen.end(), [code](const Method& method) { return method.needs == code; });
}

bool needs_own_program(std::string_view method) {
  return method == automatic || std::any_of(methods.begin(), methods.end(), [method](const Method& candidate) {
           return candidate.name == method && candidate.needs != Code::None;
         });
}

}  // namespace mbcc::model
