#include "emit/class_writer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "emit/code.hpp"
#include "emit/targets.hpp"

namespace mbcc::cpp {

namespace {

using program::IslandIndices;
using program::Unknowns;

/// `body` two columns further in.
std::string indent(std::string_view body) {
  std::string indented;
  while (!body.empty()) {
    const std::size_t end = body.find('\n');
    const std::string_view line = body.substr(0, end);
    indented += line.empty() ? "\n" : fmt::format("  {}\n", line);
    body = end == std::string_view::npos ? std::string_view{} : body.substr(end + 1);
  }
  return indented;
}

std::string count(std::size_t number, std::string_view noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string argument(std::string_view name, bool is_read) {
  return is_read ? std::string(name) : fmt::format("/*{}*/", name);
}

std::string function(std::string_view purpose, std::string_view signature, const std::string& body) {
  return body.empty() ? fmt::format("\n/// {}\n{} {{}}\n", purpose, signature)
                      : fmt::format("\n/// {}\n{} {{\n{}}}\n", purpose, signature, indent(body));
}

/// A right-hand side of up to this many operations is worth a copy in every stage of an integrator, which then keeps
/// the rates in registers (measured: 30 % of a chain of 3 links, nothing from 10 links on).
constexpr std::size_t most_operations_inlined = 150;

std::size_t operations(const program::Kernel& kernel) {
  std::size_t count = 0;
  const auto add = [&count](const program::Section& section) {
    for (const program::Unit& unit : section.units) {
      count += unit.order.size();
    }
  };
  for (const program::Section& section : kernel.sections) {
    add(section);
  }
  for (const program::IslandSolve& island : kernel.islands) {
    add(island.solve);
  }
  return count;
}

/// A function of the number of an island: one case per island, and what to return for any other.
std::string island_switch(std::size_t islands, std::string_view signature, std::string_view case_format,
                          std::string_view otherwise) {
  std::string text = fmt::format("{} {{\n  switch (island) {{\n", signature);
  for (std::size_t i = 1; i <= islands; ++i) {
    text += fmt::format("    case {}:\n      return {};\n", i - 1, fmt::format(fmt::runtime(case_format), i));
  }
  return text + fmt::format("    default:\n      {};\n  }}\n}}\n", otherwise);
}

}  // namespace

std::string comment_text(std::string_view text) {
  std::string line;
  for (const char c : text) {
    line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return !line.empty() && line.back() == '\\' ? line + " " : line;
}

ClassWriter::ClassWriter(const program::Program& program, const model::System& system, const Sources& sources)
    : program_(program), system_(system), sources_(sources), naming_(make_naming(system, program)) {}

std::string ClassWriter::summary() const {
  return fmt::format("/// `{}`: {}, {}, {} in {}.\n", comment_text(system_.name),
                     count(system_.coordinates.size(), "coordinate"), count(system_.speeds.size(), "speed"),
                     count(system_.constraints.size(), "constraint"), count(program_.islands.size(), "island"));
}

std::string ClassWriter::functions() const {
  std::string text =
      "/// Values of the parameters; call prepare() after a change.\n"
      "std::span<double> parameters() { return parameters_; }\n";
  text += function("What depends on parameters alone.", "void prepare()", body(program_.prepare).text);
  text += initial_state();
  text += set_time();
  text += rates();
  text += program_.series ? series() : "";
  text += program_.tangent ? tangent() : "";
  text += program_.velocity_shifts.islands.empty() ? "" : project();
  text += program_.islands.empty() ? "" : island_functions();
  text += change("Changes of the speeds from those of uncoupled ones, which `rate` holds.", "couple", program_.couple);
  text += change("Changes of uncoupled speeds from those of the speeds, which `rate` holds.", "uncouple",
                 program_.uncouple);
  text += change("How the coordinates move with a displacement along the speeds, which `rate` holds.", "move",
                 program_.move);
  text += system_.constraints.empty() ? "" : constraint_errors();
  text += program_.energy.sections.front().has_stores() ? energy() : "";
  text += system_.outputs.empty() ? "" : outputs();
  text += system_.forces.empty() ? "" : applied_forces();
  return text;
}

std::string ClassWriter::members() const {
  std::string text;
  for (std::size_t i = 0; i < program_.islands.size(); ++i) {
    text += island_members(i);
  }
  if (!program_.velocity_shifts.islands.empty()) {
    text += program_.position_shifts.islands.empty() ? "" : shifts("shift_positions", program_.position_shifts);
    text += shifts("shift_velocities", program_.velocity_shifts);
  }
  text += fmt::format("std::array<double, {}> parameters_{{", system_.parameters.size());
  for (std::size_t i = 0; i < system_.parameters.size(); ++i) {
    text += (i == 0 ? "" : ", ") + literal(system_.parameters[i].value).text;
  }
  text += "};\n";
  text += naming_.keeps_time ? "double t_ = 0.0;\n" : "";
  for (const auto* kernel : {&program_.prepare, &program_.time}) {
    for (const program::NodeId id : kernel->provides) {
      text += fmt::format("double {} = 0.0;\n", naming_.members.at(id));
    }
  }
  for (std::size_t i = 0; i < program_.islands.size(); ++i) {
    const IslandIndices& island = program_.islands[i];
    text += fmt::format("mbrt::IslandStorage<{}, {}> island_{}_;\n", island.constraints.size(), island.speeds.size(),
                        i + 1);
  }
  return text;
}

Body ClassWriter::body(const program::Kernel& kernel, const Comments& comments) const {
  return write_kernel(kernel, program_, naming_, comments);
}

/// The constraints of an island, those of one statement on one line.
std::string ClassWriter::island_comment(std::size_t island) const {
  std::vector<std::size_t> rows = program_.islands[island].constraints;
  std::sort(rows.begin(), rows.end());
  std::string text = fmt::format("island {} of {}\n", island + 1, program_.islands.size());
  for (std::size_t k = 0; k < rows.size();) {
    const model::Constraint& first = system_.constraints[rows[k]];
    std::size_t last = k;
    while (last + 1 < rows.size() && system_.constraints[rows[last + 1]].span == first.span) {
      ++last;
    }
    const std::string& last_name = system_.constraints[rows[last]].name;
    text += fmt::format("  {}{} ({}): {}\n", first.name, last == k ? "" : " ... " + last_name,
                        comment_text(sources_.place(first.span)), comment_text(first.text));
    k = last + 1;
  }
  return text;
}

std::string ClassWriter::initial_state() const {
  return function("The model's own start.", "State initial_state() const",
                  "State y{};\n" + body(program_.initial).text + "return y;\n");
}

std::string ClassWriter::set_time() const {
  const std::string text = (naming_.keeps_time ? "t_ = t;\n" : "") + body(program_.time).text;
  return function("What depends on time alone.", fmt::format("void set_time(double {})", argument("t", !text.empty())),
                  text);
}

std::string ClassWriter::rates() const {
  const auto& sections = program_.rates.sections;
  Comments comments;
  comments.sections = {"", sections[1].has_stores() ? "without constraints" : ""};
  for (std::size_t i = 0; i < program_.islands.size(); ++i) {
    comments.islands.push_back(island_comment(i));
  }
  const Body rates = body(program_.rates, comments);
  const std::string_view inlining =
      operations(program_.rates) <= most_operations_inlined ? "[[gnu::always_inline]] " : "";
  return function("Time derivative of the state.",
                  fmt::format("{}void rates(const State& {}, State& {}){}", inlining, argument("y", rates.reads_state),
                              argument("rate", !rates.text.empty()), program_.islands.empty() ? " const" : ""),
                  rates.text);
}

/// The pass of Note [series] (program/series_plan.hpp).
std::string ClassWriter::series() const {
  const program::SeriesKernels& series = *program_.series;
  const Opening start = write_opening(series.start, program_, naming_);
  const Opening fast = write_opening(series.fast, program_, start.within);
  const Body slow = write_kernel(series.slow, program_, fast.within, {});
  const Body solve = write_kernel(series.solve, program_, fast.within, {});
  std::string body = start.body.text;
  body += "s.begin();\nfor (std::size_t j = 0; j < y.size(); ++j) {\n  s.state[0][j] = y[j];\n}\n";
  body += "for (std::size_t k = 0; k < order; ++k) {\n" + indent(fast.body.text);
  body += slow.text.empty() ? "" : "  if (k > 0) {\n" + indent(indent(slow.text)) + "  }\n";
  body += "  s.sum(k + 2);\n" + indent(solve.text) + "}\nreturn true;\n";
  return fmt::format(
             "\n/// Where `expand` computes: for lanes of products, slow products, squares and slow squares, and "
             "switches.\n"
             "using Series = mbrt::Series<coordinates, speeds, {}, {}, {}, {}, {}>;\n",
             series.products, series.slow_products, series.squares, series.slow_squares, series.switches) +
         function(
             "Taylor coefficients of the motion through `y`, up to `order`. False where the plain solve is not safe.",
             "bool expand(const State& y, std::size_t order, Series& s)", body);
}

std::string ClassWriter::tangent() const {
  const Body tangent = body(*program_.tangent);
  return function(
      "Derivative of the rates along a direction of the state. False where the solve is too inaccurate for it.",
      fmt::format("bool tangent(const State& {}, const State& direction, State& change) const",
                  argument("y", tangent.reads_state)),
      tangent.text + "return true;\n");
}

std::string ClassWriter::project() const {
  std::string text = "std::array<double, speeds> shift{};\n";
  const auto shift = [&](std::string_view kernel, std::string_view component) {
    text += fmt::format(
        "{}(y, shift);\n"
        "for (std::size_t i = 0; i < speeds; ++i) {{\n"
        "  y[{}] += shift[i];\n"
        "}}\n",
        kernel, component);
  };
  if (!program_.position_shifts.islands.empty() && program_.move.sections.front().has_stores()) {
    text +=
        "shift_positions(y, shift);\n"
        "State rate{};\n"
        "for (std::size_t i = 0; i < speeds; ++i) {\n"
        "  rate[coordinates + i] = shift[i];\n"
        "}\n"
        "std::array<double, coordinates> moved{};\n"
        "move(y, rate, moved);\n"
        "for (std::size_t i = 0; i < coordinates; ++i) {\n"
        "  y[i] += moved[i];\n"
        "}\n";
  } else if (!program_.position_shifts.islands.empty()) {
    shift("shift_positions", "i");
  }
  shift("shift_velocities", "coordinates + i");
  return function(
      "Moves a state onto the constraints: a step of Newton's method for the coordinates, then one for the "
      "speeds.",
      "void project(State& y)", text);
}

std::string ClassWriter::shifts(std::string_view name, const program::Kernel& kernel) const {
  const Body shifts = body(kernel);
  return fmt::format("void {}(const State& {}, std::array<double, speeds>& shift) {{\n{}}}\n\n", name,
                     argument("y", shifts.reads_state), indent(shifts.text));
}

std::string ClassWriter::island_functions() const {
  const std::size_t islands = program_.islands.size();
  return "\n/// Scales and counters of one island, and storage for its rows.\n" +
         island_switch(islands, "mbrt::Island island(int island)", "island_{}_.view()", "return {}") +
         "\n/// Fills island(k).rows with the rows at a state.\n" +
         island_switch(islands, "void island_rows(int island, const State& y)", "rows_{}(y)", "return");
}

std::string ClassWriter::constraint_errors() const {
  const Body errors = body(program_.constraint_errors);
  const bool any_holonomic = std::any_of(system_.constraints.begin(), system_.constraints.end(),
                                         [](const model::Constraint& constraint) { return constraint.holonomic; });
  return function(
      "Errors of the constraints: value (where holonomic), its rate (else the value), and A u' - b.",
      fmt::format("void constraint_errors(const State& {}, const State& {}, std::span<double> {},\n"
                  "                       std::span<double> velocity, std::span<double> acceleration) const",
                  argument("y", errors.reads_state), argument("rate", errors.reads_rate),
                  argument("position", any_holonomic)),
      errors.text);
}

std::string ClassWriter::change(std::string_view purpose, std::string_view name, const program::Kernel& kernel) const {
  if (!kernel.sections.front().has_stores()) {
    return "";
  }
  const Body change = body(kernel);
  return function(purpose,
                  fmt::format("void {}(const State& {}, const State& {}, std::span<double> shift) const", name,
                              argument("y", change.reads_state), argument("rate", change.reads_rate)),
                  change.text);
}

/// Turns u of an island into the changes of its speeds, where inertia couples some of them.
std::string ClassWriter::coupling(std::size_t island) const {
  const std::vector<std::size_t>& speeds = program_.islands[island].speeds;
  std::string before, after;
  bool couples = false;
  for (std::size_t j = 0; j < speeds.size(); ++j) {
    before += fmt::format("rate[{}] = u[{}];\n", system_.coordinates.size() + speeds[j], j);
    for (const program::Unit& unit : program_.couple.sections.front().units) {
      if (unit.stores.front().index == speeds[j]) {
        couples = true;
        after += fmt::format("u[{}] = shift[{}];\n", j, speeds[j]);
      }
    }
  }
  return couples ? "State rate{};\n" + before + "std::array<double, speeds> shift{};\ncouple(y, rate, shift);\n" + after
                 : "";
}

std::string ClassWriter::energy() const {
  const Body energy = body(program_.energy);
  return function("Kinetic energy, and the potential of the constant forces.",
                  fmt::format("double energy(const State& {}) const", argument("y", energy.reads_state)), energy.text);
}

std::string ClassWriter::outputs() const {
  const Body outputs = body(program_.outputs);
  return function("The outputs of the model, at a state and its rate.",
                  fmt::format("void outputs(const State& {}, const State& {}, std::span<double> values) const",
                              argument("y", outputs.reads_state), argument("rate", outputs.reads_rate)),
                  outputs.text);
}

std::string ClassWriter::applied_forces() const {
  const Body forces = body(program_.applied_forces);
  return function("Each applied force, to find the one that is not a number.",
                  fmt::format("void applied_forces(const State& {}, std::span<double> values) const",
                              argument("y", forces.reads_state)),
                  forces.text);
}

/// The rows of an island, and its accelerations where the plain solve is not safe.
std::string ClassWriter::island_members(std::size_t island) const {
  const std::size_t number = island + 1;
  const Body rows = body(program_.island_rows[island]);
  std::string text = fmt::format("[[gnu::noinline, gnu::cold]] void rows_{}(const State& {}) {{\n", number,
                                 argument("y", rows.reads_state));
  text += fmt::format("  const mbrt::IslandRows rows = island_{}_.view().rows;\n  rows.clear();\n", number);
  text += indent(rows.text) + "}\n\n";

  text += climb(island, Unknowns::Accelerations,
                "mbrt::climb(island, u);\n"
                "for (std::size_t j = 0; j < u.size(); ++j) {\n"
                "  u[j] += island.rows.free[j];\n"
                "}\n");
  const auto solves = [island](const program::Kernel& kernel) {
    return std::any_of(kernel.islands.begin(), kernel.islands.end(),
                       [island](const program::IslandSolve& solve) { return solve.island == island; });
  };
  if (solves(program_.position_shifts)) {
    text +=
        climb(island, Unknowns::Displacements,
              nonholonomic_rows_ignored(island) +
                  "mbrt::correct(island, island.rows.position, mbrt::extent(std::span(y).first(coordinates)), u);\n");
  }
  if (solves(program_.velocity_shifts)) {
    text += climb(island, Unknowns::SpeedChanges,
                  "mbrt::correct(island, island.rows.velocity, mbrt::extent(std::span(y).last(speeds)), u);\n");
  }
  return text;
}

/// The rest of the rank ladder: `solve` computes u from `island`, whose rows are those at y.
std::string ClassWriter::climb(std::size_t island, program::Unknowns unknowns, const std::string& solve) const {
  return fmt::format(
             "[[gnu::noinline, gnu::cold]] std::array<double, {1}> {2}_{0}(State y) {{\n"
             "  rows_{0}(y);\n"
             "  const mbrt::Island island = island_{0}_.view();\n"
             "  std::array<double, {1}> u{{}};\n",
             island + 1, program_.islands[island].speeds.size(), climb_of(unknowns)) +
         indent(solve + coupling(island)) +
         "  return u;\n"
         "}\n\n";
}

/// Constraints on speeds do not bind coordinates.
std::string ClassWriter::nonholonomic_rows_ignored(std::size_t island) const {
  std::string text;
  const std::vector<std::size_t>& rows = program_.islands[island].constraints;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (!system_.constraints[rows[k]].holonomic) {
      text += fmt::format("island.rows.ignore({});\n", k);
    }
  }
  return text;
}

}  // namespace mbcc::cpp
