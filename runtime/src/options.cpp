#include "options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <optional>
#include <string_view>

#include "mbrt/dop853.hpp"
#include "mbrt/radau.hpp"
#include "mbrt/rk4.hpp"
#include "mbrt/taylor.hpp"
#include "methods.hpp"
#include "option_values.hpp"

namespace mbrt {
namespace {

/// The line as typed, before it is checked against the model.
struct Typed {
  Options options;
  std::string method = "";       // empty: neither the model nor the line names one
  double step = not_given;       // on the line
  double tolerance = not_given;  // likewise
  std::vector<std::string> set;
  std::vector<std::string> initial;
  std::vector<std::string> fix;
  std::string project = "";  // empty: as is right for the method
  std::string stabilize = "";
};

/// What `--fix` names.
std::vector<std::size_t> fixed(const Typed& typed, std::span<const std::string_view> state) {
  if (!typed.fix.empty() && !typed.options.assemble) {
    throw UsageError{"`--fix` holds what `--assemble` would move: it needs `--assemble`"};
  }
  std::vector<std::size_t> indices;
  for (const std::string& name : typed.fix) {
    indices.push_back(index_of(name, "coordinate or speed", state));
  }
  return indices;
}

std::string or_default(const char* text, double value) {
  return std::isnan(value) ? std::string(text) : fmt::format("{} [{}]", text, value);
}

/// "`rk4`, `dop853`".
std::string names_of_methods() {
  std::string names;
  for (const MethodEntry& method : methods()) {
    names += fmt::format("{}`{}`", names.empty() ? "" : ", ", method.name);
  }
  return names;
}

std::string method_help() {
  std::string text;
  for (const MethodEntry& method : methods()) {
    text += fmt::format("{}: {}; ", method.name, method.description);
  }
  return text + "auto: rk4 where the model gives a step and no method, else one of the others by tolerance";
}

void add_flags(CLI::App& app, const Description& model, Typed& typed) {
  const Defaults& defaults = model.defaults;
  Options& options = typed.options;
  const auto number = [&app](const char* flag, const std::string& help, auto& target, auto check) {
    app.add_option_function<std::string>(
           flag, [&target, flag, check](const std::string& text) { target = check(text, flag); }, help)
        ->type_name("NUMBER");
  };
  number("--from", or_default("start time", options.from), options.from, finite);
  number("--to", or_default("end time", defaults.to), options.to, finite);
  number("--step", or_default("step of rk4", defaults.step), typed.step, finite);
  app.add_option("--method", typed.method, method_help())->type_name("NAME");
  number("--tolerance",
         fmt::format("error per step, relative to the state and its size at the start, of methods that choose their "
                     "step [{}]",
                     options.tolerance),
         typed.tolerance, positive);
  app.add_option("--set", typed.set, "value of a parameter, any number of times")->type_name("NAME=VALUE");
  app.add_option("--initial", typed.initial, "value of a coordinate or speed at the start")->type_name("NAME=VALUE");
  app.add_flag("--assemble", options.assemble, "move the start to the nearest consistent one");
  app.add_option("--fix", typed.fix, "hold a coordinate or speed while assembling, any number of times")
      ->type_name("NAME");
  app.add_option("--project", typed.project, "move each step's end onto the constraints [on, with rk4 off]")
      ->type_name("on|off");
  app.add_option("--stabilize", typed.stabilize,
                 "Baumgarte stabilization, h'' + 2 B1 B2 h' + B2^2 h = 0 and g' + B3 g = 0")
      ->type_name("B1,B2,B3");
  number("--cutoff", fmt::format("relative size below which singular values count as zero [{}]", default_cutoff),
         options.cutoff, positive);
  app.add_option("--csv", options.csv, "record the motion in this file; `-` is standard output")->type_name("FILE");
  app.add_option("--npy", options.npy, "record the motion in this file, in the form of NumPy")->type_name("FILE");
  app.add_flag("--residuals", options.residuals, "record the errors of the constraints and the energy as well");
  number("--every", or_default("distance of recorded rows in time; without it, each step", defaults.every),
         options.every, positive);
  app.add_option("--summary", options.summary, "write what the run found to this file, as JSON")->type_name("FILE");
  app.add_flag("--quiet", options.quiet, "no summary on standard output, no progress");
  app.add_flag("--progress", options.progress,
               "show on standard error how far the run is, also where it is short or no terminal");
  number("--repeat", "then integrate this often unobserved and report the fastest", options.repeat, positive_integer);
}

void refuse_unknown(const CLI::App& app) {
  const std::vector<std::string> unknown = app.remaining();
  if (unknown.empty()) {
    return;
  }
  std::vector<std::string> flags;
  for (const CLI::Option* const option : app.get_options()) {
    flags.push_back("--" + option->get_single_name());
  }
  const std::vector<std::string_view> candidates(flags.begin(), flags.end());
  throw UsageError{fmt::format("there is no flag `{}`{}", unknown.front(), guess_at(unknown.front(), candidates))};
}

/// The method to use, where none is named or `auto`.
const char* choose_method(const Description& model, const Typed& typed) {
  const bool has_step = !std::isnan(typed.options.step);
  if (typed.method.empty() && has_step) {
    return Rk4::name;
  }
  return model.has_series && typed.options.tolerance <= tolerance_for_series ? Taylor::name : Dop853::name;
}

void check_tangent(const Description& model, const Typed& typed) {
  if (typed.options.method == Radau::name && !model.has_tangent) {
    throw UsageError{
        "this program has no derivatives of its rates: compile the model with `--method radau`, or let its `integrate` "
        "name the method"};
  }
}

void check_series(const Description& model, const Typed& typed) {
  if (typed.options.method != Taylor::name) {
    return;
  }
  if (!model.has_series) {
    throw UsageError{
        "this program has no Taylor series: compile the model with `--method taylor`, or let its `integrate` name the "
        "method"};
  }
  if (!typed.stabilize.empty()) {
    throw UsageError{"`--stabilize` changes the equations, whose series `taylor` has: use `dop853`"};
  }
}

void set_method(const Description& model, Typed& typed) {
  Options& options = typed.options;
  options.step = std::isnan(typed.step) ? options.step : typed.step;
  options.tolerance = std::isnan(typed.tolerance) ? options.tolerance : typed.tolerance;
  const bool is_auto = typed.method.empty() || typed.method == "auto";
  options.method = is_auto ? choose_method(model, typed) : typed.method;
  const MethodEntry* const method = find_method(options.method);
  if (method == nullptr) {
    throw UsageError{fmt::format("the method `{}` is not part of this version of mbcc, which has {} and `auto`",
                                 typed.method, names_of_methods())};
  }
  options.chosen_by_auto = is_auto && method->chooses_step;
  check_series(model, typed);
  check_tangent(model, typed);
  if (options.tolerance < std::numeric_limits<double>::epsilon()) {
    throw UsageError{fmt::format("the tolerance {} is below {:.2g}, the rounding of numbers", options.tolerance,
                                 std::numeric_limits<double>::epsilon())};
  }
  if (!method->chooses_step && !std::isnan(typed.tolerance)) {
    fmt::print(stderr, "warning: `--tolerance` has no effect on `{}`, whose step is constant\n", options.method);
  }
  if (method->chooses_step && !std::isnan(typed.step)) {
    fmt::print(stderr, "warning: `--step` has no effect on `{}`, which chooses its steps\n", options.method);
  }
  if (typed.project != "" && typed.project != "on" && typed.project != "off") {
    throw UsageError{fmt::format("`--project {}` is neither `on` nor `off`", typed.project)};
  }
  options.project = typed.project.empty() ? method->chooses_step : typed.project == "on";
}

std::optional<Stabilization> stabilization(const std::string& text) {
  if (text.empty()) {
    return std::nullopt;
  }
  std::vector<double> constants;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    constants.push_back(positive(std::string_view(text).substr(begin, end - begin), "--stabilize"));
    begin = end + 1;
  }
  if (constants.size() != 3) {
    throw UsageError{fmt::format("`--stabilize {}` is not of the form B1,B2,B3", text)};
  }
  return Stabilization{constants[0], constants[1], constants[2]};
}

void check_times(const Options& options) {
  if (std::isnan(options.to)) {
    throw UsageError{"neither the model nor `--to` says when to stop"};
  }
  if (options.to < options.from) {
    throw UsageError{fmt::format("the end time {} is before the start time {}", options.to, options.from)};
  }
}

/// Of a method whose step is constant.
void check_step(const Options& options) {
  if (std::isnan(options.step)) {
    throw UsageError{fmt::format("neither the model nor `--step` gives the step of `{}`", options.method)};
  }
  if (options.step <= 0) {
    throw UsageError{fmt::format("the step {} is not positive", options.step)};
  }
  const double steps = (options.to - options.from) / options.step;
  // Beyond, from + i step no longer tells neighbouring times apart.
  if (steps > 1 / std::numeric_limits<double>::epsilon()) {
    throw UsageError{fmt::format("the step {} is too small: {:.3g} steps", options.step, steps)};
  }
  const double whole = steps > 0 ? std::max(1.0, std::round(steps)) : 0;
  if (std::abs(steps - whole) > 1e-9 * std::max(1.0, steps)) {
    fmt::print(stderr, "warning: the step {} does not divide the span from {} to {}: the last step is shortened\n",
               options.step, options.from, options.to);
  }
}

void check_files(const Options& options) {
  const std::pair<const char*, const std::string&> files[] = {
      {"--csv", options.csv}, {"--npy", options.npy}, {"--summary", options.summary}};
  for (const auto& [flag, file] : files) {
    for (const auto& [other_flag, other] : files) {
      if (flag != other_flag && !file.empty() && file == other) {
        throw UsageError{fmt::format("`{}` and `{}` both write to `{}`", flag, other_flag, file)};
      }
    }
  }
  if (options.npy == "-") {
    throw UsageError{"`--npy` needs a file: the number of rows stands at its beginning and is known at the end"};
  }
  if (options.residuals && options.csv.empty() && options.npy.empty()) {
    throw UsageError{"`--residuals` adds to what is recorded: it needs `--csv` or `--npy`"};
  }
  if (options.cutoff > largest_cutoff) {
    throw UsageError{fmt::format("the cut-off {} is above {}", options.cutoff, largest_cutoff)};
  }
}

Options checked(const Description& model, Typed typed) {
  std::vector<std::string_view> parameters;
  for (const ParameterEntry& parameter : model.parameters) {
    parameters.emplace_back(parameter.name);
  }
  std::vector<std::string_view> state(model.coordinates.begin(), model.coordinates.end());
  state.insert(state.end(), model.speeds.begin(), model.speeds.end());
  set_method(model, typed);
  check_times(typed.options);
  if (!find_method(typed.options.method)->chooses_step) {
    check_step(typed.options);
  }
  typed.options.stabilization = stabilization(typed.stabilize);
  check_files(typed.options);
  typed.options.parameters = assignments(typed.set, "--set", "parameter", parameters);
  typed.options.initial = assignments(typed.initial, "--initial", "coordinate or speed", state);
  typed.options.fixed = fixed(typed, state);
  return typed.options;
}

Typed defaults_of(const Description& model) {
  const Defaults& defaults = model.defaults;
  Typed typed;
  typed.options.from = std::isnan(defaults.from) ? 0 : defaults.from;
  typed.options.to = defaults.to;
  typed.options.step = defaults.step;
  typed.options.every = defaults.every;
  typed.options.tolerance = std::isnan(defaults.tolerance) ? default_tolerance : defaults.tolerance;
  typed.method = defaults.method != nullptr ? defaults.method : "";
  return typed;
}

}  // namespace

std::variant<Options, ExitCode> read_command_line(const Description& model, int argc, char** argv) {
  Typed typed = defaults_of(model);
  CLI::App app(fmt::format("simulates {} (mbcc {})", model.model, model.mbcc_version));
  app.allow_extras();
  add_flags(app, model, typed);
  try {
    app.parse(argc, argv);
    refuse_unknown(app);
    return checked(model, std::move(typed));
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", app.help());
    return ExitFine;
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string_view text = error.what();
    fmt::print(stderr, "error: `{}` {}\n", text.substr(0, text.find(':')),
               text.ends_with("missing") ? "needs a value" : "is given more than once");
  } catch (const CLI::ParseError& error) {
    fmt::print(stderr, "error: {}\n", error.what());
  } catch (const UsageError& error) {
    fmt::print(stderr, "error: {}\n", error.message);
  }
  return ExitUsage;
}

}  // namespace mbrt
