#include "emit/emit.hpp"

#include <fmt/format.h>

#include "emit/class_writer.hpp"
#include "emit/description.hpp"
#include "emit/templates.hpp"
#include "model/methods.hpp"

namespace mbcc {

namespace {

std::string base_name(std::string_view file) {
  const std::size_t slash = file.find_last_of('/');
  return std::string(slash == std::string_view::npos ? file : file.substr(slash + 1));
}

std::string stem_of(std::string_view file) {
  const std::string base = base_name(file);
  const std::size_t dot = base.find_last_of('.');
  return dot == 0 ? base : base.substr(0, dot);
}

/// The file's name; `exp.mbd` becomes `exp_model`.
std::string namespace_of(std::string_view model_file) {
  const std::string name = cpp::mangle(stem_of(model_file));
  return cpp::is_global_name(name) ? name + "_model" : name;
}

std::string options_text(const EmitOptions& options) {
  return std::string(options.library ? " --library" : "") + (options.strict ? " --strict" : "") +
         (options.method.empty() ? "" : " --method " + options.method);
}

/// The headers of the methods that are compiled with a model, and their names for mbrt::simulate.
struct MethodCode {
  std::string includes;
  std::string types;
};

MethodCode code_of_methods(const model::Integration& integration, bool has_series) {
  MethodCode code;
  for (const model::Method& method : methods_of(integration)) {
    if (method.needs == model::Code::Series && !has_series) {
      continue;  // what `auto` cannot choose
    }
    code.includes += fmt::format("#include <mbrt/{}.hpp>\n", method.name);
    code.types += fmt::format("{}mbrt::{}", code.types.empty() ? "" : ", ", method.type);
  }
  return code;
}

}  // namespace

std::string generated_file_name(std::string_view model_file, const EmitOptions& options) {
  return stem_of(model_file) + (options.library ? ".hpp" : ".cpp");
}

std::string emit(const program::Program& program, const model::System& system, const Sources& sources,
                 const EmitOptions& options) {
  using namespace cpp;
  const ClassWriter writer(program, system, sources);
  const std::string& model_file = sources[0].name();
  const std::string name_space = namespace_of(model_file);
  const std::string model_class =
      fill(template_text("model_class.in"), {{"namespace", name_space},
                                             {"summary", writer.summary()},
                                             {"interface_version", std::to_string(interface_version)},
                                             {"coordinates", std::to_string(system.coordinates.size())},
                                             {"speeds", std::to_string(system.speeds.size())},
                                             {"constraints", std::to_string(system.constraints.size())},
                                             {"description", write_description(program, system, sources)},
                                             {"functions", writer.functions()},
                                             {"members", writer.members()}});
  Values values{{"file", comment_text(generated_file_name(model_file, options))},
                {"version", std::string(version)},
                {"source", comment_text(base_name(model_file))},
                {"options", options_text(options)},
                {"model_class", model_class}};
  if (options.library) {
    values.emplace("series_include", program.series ? "#include <mbrt/series.hpp>\n" : "");
  } else {
    const MethodCode methods = code_of_methods(system.integration, program.series.has_value());
    values.emplace("namespace", name_space);
    values.emplace("method_includes", methods.includes);
    values.emplace("methods", methods.types);
  }
  return fill(template_text(options.library ? "model.hpp.in" : "simulation.cpp.in"), values);
}

std::optional<EmitOptions> options_of(std::string_view emitted) {
  constexpr std::string_view key = "\n// mbcc options:";
  const std::size_t at = emitted.find(key);
  if (at == std::string_view::npos) {
    return std::nullopt;
  }
  std::string_view line = emitted.substr(at + key.size());
  line = line.substr(0, line.find('\n'));
  const auto names = [&](std::string_view option) { return line.find(option) != std::string_view::npos; };
  constexpr std::string_view method = " --method ";
  return EmitOptions{names(" --library"), names(" --strict"),
                     names(method) ? std::string(line.substr(line.find(method) + method.size())) : ""};
}

}  // namespace mbcc
