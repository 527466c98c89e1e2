#include "emit/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emit/code.hpp"
#include "emit/emit.hpp"
#include "model/columns.hpp"

namespace mbcc::cpp {

namespace {

/// `static constexpr std::array<type, n> name = {...};`, broken into lines of a readable length. Nested braces are for
/// rows that are aggregates themselves.
std::string table(std::string_view type, std::string_view name, const std::vector<std::string>& rows) {
  std::string text = fmt::format("static constexpr std::array<{}, {}> {}", type, rows.size(), name);
  if (rows.empty()) {
    return text + "{};\n";
  }
  text += " = {{";
  std::size_t column = 1000;
  for (const std::string& row : rows) {
    if (column + row.size() > 110) {
      text += "\n    ";
      column = 4;
    } else {
      text += " ";
      ++column;
    }
    text += row + ",";
    column += row.size() + 1;
  }
  return text + "\n}};\n";
}

template <class Items, class Text>
std::vector<std::string> texts(const Items& items, const Text& text_of) {
  std::vector<std::string> texts;
  for (const auto& item : items) {
    texts.push_back(text_of(item));
  }
  return texts;
}

std::string number_or_not_given(const std::optional<double>& value) {
  return value ? literal(*value).text : "mbrt::not_given";
}

std::string islands(const program::Program& program) {
  std::string text;
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < program.islands.size(); ++i) {
    const program::IslandIndices& island = program.islands[i];
    const auto number = [](std::size_t index) { return std::to_string(index); };
    text += table("int", fmt::format("island_{}_constraints", i + 1), texts(island.constraints, number));
    text += table("int", fmt::format("island_{}_speeds", i + 1), texts(island.speeds, number));
    rows.push_back(fmt::format("{{island_{0}_constraints, island_{0}_speeds}}", i + 1));
  }
  return text + table("mbrt::IslandEntry", "islands", rows);
}

}  // namespace

std::string quote(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      quoted += fmt::format("\\{:03o}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + "\"";
}

std::string write_description(const program::Program& program, const model::System& system, const Sources& sources) {
  std::string text;
  const auto names = [&](std::string_view table_name, const auto& items, auto member) {
    text += table("const char*", table_name, texts(items, [&](const auto& item) { return quote(item.*member); }));
  };
  names("coordinates", system.coordinates, &model::Coordinate::name);
  names("speeds", system.speeds, &model::Speed::name);
  names("accelerations", system.speeds, &model::Speed::acceleration);
  names("outputs", system.outputs, &model::Output::name);
  text += table("mbrt::ParameterEntry", "parameters", texts(system.parameters, [](const model::Parameter& parameter) {
                  return fmt::format("{{{}, {}}}", quote(parameter.name), literal(parameter.value).text);
                }));
  text +=
      table("mbrt::ConstraintEntry", "constraints", texts(system.constraints, [&](const model::Constraint& item) {
              return fmt::format("{{{}, {}, {}}}", quote(item.name), quote(sources.place(item.span)), item.holonomic);
            }));
  text += table("mbrt::ForceEntry", "forces", texts(system.forces, [&](const model::Force& force) {
                  return fmt::format("{{{}, {}}}", quote(force.name), quote(sources.place(force.span)));
                }));
  text += islands(program);
  const std::vector<int> columns = model::columns(system);
  if (!columns.empty()) {
    text += table("int", "columns", texts(columns, [](int index) { return std::to_string(index); }));
  }
  const model::Integration& integration = system.integration;
  const bool has_energy = program.energy.sections.front().has_stores();
  text += fmt::format(
      "static constexpr mbrt::Description description{{\n"
      "    {}, {}, coordinates, speeds, accelerations, outputs, parameters, constraints, forces, islands, {}, {},\n"
      "    {{{}, {}, {}, {}, {}, {}}}{}}};\n",
      quote(system.name), quote(version), has_energy, program.series.has_value(), number_or_not_given(integration.from),
      number_or_not_given(integration.to), number_or_not_given(integration.step),
      number_or_not_given(integration.tolerance), number_or_not_given(integration.every),
      integration.method ? quote(*integration.method) : "nullptr",
      program.tangent   ? columns.empty() ? ", {}, true" : ", columns, true"
      : columns.empty() ? ""
                        : ", columns");
  return text;
}

}  // namespace mbcc::cpp
